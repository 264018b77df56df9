#include "import/grids/nrrd_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// "space directions" and "Space Directions" are one field; "datafile" is "data file" too.
std::string field_name(std::string_view name) {
  std::string result = lower_case(trimmed(name));
  std::erase(result, ' ');
  return result;
}

/// Splits blank-separated vectors, "(1,0,0) none (0, 0, 2)", into one text each.
std::vector<std::string> vectors_of(std::string_view text) {
  std::vector<std::string> vectors;
  while (!(text = trimmed(text)).empty()) {
    const char closing = text.front() == '(' ? ')' : ' ';
    const std::size_t end = std::min(text.find(closing), text.size() - 1);
    vectors.emplace_back(trimmed(text.substr(0, end + 1)));
    text.remove_prefix(end + 1);
  }
  return vectors;
}

/// The texts between quotes: "mm" "" "mm".
std::vector<std::string> quoted_texts_of(std::string_view text) {
  std::vector<std::string> texts;
  for (std::size_t begin = text.find('"'); begin != std::string_view::npos;) {
    const std::size_t end = text.find('"', begin + 1);
    if (end == std::string_view::npos) break;
    texts.emplace_back(trimmed(text.substr(begin + 1, end - begin - 1)));
    begin = text.find('"', end + 1);
  }
  return texts;
}

glm::dvec3 vector_of(const fs::path& file, std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  const std::vector<double> numbers = numbers_of(text);
  const bool usable = numbers.size() == 3 && std::all_of(numbers.begin(), numbers.end(),
                                                         [](double n) { return std::isfinite(n); });
  if (!usable)
    refuse(file, "a vector of the header is not usable", "(x,y,z) in finite numbers",
           printable(text));
  return {numbers[0], numbers[1], numbers[2]};
}

/// One word an axis; none at all where the field is absent.
std::vector<std::string> per_axis(const fs::path& file, const TextHeader& text, const char* name,
                                  std::size_t axes) {
  const auto value = text.find(name);
  if (!value) return {};
  std::vector<std::string> words = name == std::string_view("spacedirections") ? vectors_of(*value)
                                   : name == std::string_view("units") ? quoted_texts_of(*value)
                                                                       : words_of(*value);
  if (words.size() != axes) {
    refuse(file, fmt::format("the header's {} do not fit its dimension", name),
           fmt::format("{} entries", axes), std::to_string(words.size()));
  }
  return words;
}

/// NaN says "unknown" in NRRD; zero, negative and infinite say nothing.
std::optional<double> spacing_of(const fs::path& file, const std::string& word) {
  const std::string lower = lower_case(word);
  if (lower == "nan") return std::nullopt;
  const double spacing = numbers_of(word).at(0);
  if (std::isfinite(spacing) && spacing > 0) return spacing;
  refuse(file, "the voxel spacing is not usable", "numbers above 0", printable(word));
}

bool is_spatial_kind(const std::string& kind) {
  return kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

/// How NRRD says that it does not know, or that there is none.
bool is_unknown(const std::string& word) { return word == "???" || lower_case(word) == "none"; }

/// Some writers give the vectors of a direction that is none.
bool is_no_direction(std::string direction) {
  if (direction == "none") return true;
  std::erase(direction, ' ');
  return direction == "(nan,nan,nan)";
}

/// It has two names.
const char* centering_field(const TextHeader& text) {
  return text.find("centerings") ? "centerings" : "centers";
}

void take_kind(const std::string& kind, NrrdAxis& axis) {
  if (!is_spatial_kind(kind)) axis.is_spatial = false;
  axis.is_colour =
      kind == "rgb-color" || kind == "rgba-color" || kind == "3-color" || kind == "4-color";
}

}  // namespace

TextHeader parse_nrrd_header(const fs::path& file) {
  HeaderLines lines(file);
  const auto magic = lines.next();
  if (!magic || !magic->starts_with("NRRD000"))
    refuse(file, "not a NRRD header", "the magic NRRD000n");
  TextHeader header;
  while (const auto line = lines.next()) {
    if (line->empty()) break;
    if (line->front() == '#') continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string::npos) refuse(file, "a line of the header is no field", "name: value");
    const bool key_value = colon + 1 < line->size() && (*line)[colon + 1] == '=';
    if (key_value) continue;
    const std::string name = field_name(std::string_view(*line).substr(0, colon));
    header.fields[name] = trimmed(std::string_view(*line).substr(colon + 1));
    if (name != "datafile" || !header.fields[name].starts_with("LIST")) continue;
    while (auto listed = lines.next()) {
      if (!listed->empty()) header.further_lines.push_back(std::move(*listed));
    }
  }
  header.bytes = lines.position();
  return header;
}

Component nrrd_component(const fs::path& file, const TextHeader& text) {
  const std::string type = lower_case(text.find("type").value_or(""));
  const auto is_one_of = [&](auto... names) { return ((type == names) || ...); };
  if (is_one_of("signed char", "int8", "int8_t")) return Component::int8;
  if (is_one_of("uchar", "unsigned char", "uint8", "uint8_t")) return Component::uint8;
  if (is_one_of("short", "short int", "signed short", "signed short int", "int16", "int16_t"))
    return Component::int16;
  if (is_one_of("ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"))
    return Component::uint16;
  if (is_one_of("int", "signed int", "int32", "int32_t")) return Component::int32;
  if (is_one_of("uint", "unsigned int", "uint32", "uint32_t")) return Component::uint32;
  if (is_one_of("longlong", "long long", "long long int", "signed long long",
                "signed long long int", "int64", "int64_t")) {
    return Component::int64;
  }
  if (is_one_of("ulonglong", "unsigned long long", "unsigned long long int", "uint64",
                "uint64_t")) {
    return Component::uint64;
  }
  if (type == "float") return Component::float32;
  if (type == "double") return Component::float64;
  refuse(file, "this number type is not read", "8 to 64 bit integers, float or double",
         printable(type));
}

Encoding nrrd_encoding(const fs::path& file, const TextHeader& text) {
  const std::string encoding = lower_case(text.find("encoding").value_or(""));
  if (encoding == "raw") return Encoding::raw;
  if (encoding == "txt" || encoding == "text" || encoding == "ascii") return Encoding::ascii;
  if (encoding == "hex") return Encoding::hex;
  if (encoding == "gz" || encoding == "gzip") return Encoding::deflated;
  if (encoding == "bz2" || encoding == "bzip2") return Encoding::bzip2;
  refuse(file, "this NRRD encoding is not read", "raw, ascii, hex, gzip or bzip2",
         printable(encoding));
}

std::vector<NrrdAxis> nrrd_axes(const fs::path& file, const TextHeader& text) {
  const auto dimension = integer_of(text.find("dimension").value_or("")).value_or(0);
  const std::vector<std::string> sizes = words_of(text.find("sizes").value_or(""));
  if (dimension < 1 || dimension > 16 || std::cmp_not_equal(sizes.size(), dimension)) {
    refuse(file, "the header's dimension and sizes do not agree", "one size a dimension",
           fmt::format("{} and {}", dimension, sizes.size()));
  }
  const auto kinds = per_axis(file, text, "kinds", sizes.size());
  const auto spacings = per_axis(file, text, "spacings", sizes.size());
  const auto units = per_axis(file, text, "units", sizes.size());
  const auto centerings = per_axis(file, text, centering_field(text), sizes.size());
  const auto directions = per_axis(file, text, "spacedirections", sizes.size());
  std::vector<NrrdAxis> axes(sizes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    axes[i].extent = integer_of(sizes[i]).value_or(0);
    if (!kinds.empty()) take_kind(lower_case(kinds[i]), axes[i]);
    if (!spacings.empty()) axes[i].spacing = spacing_of(file, spacings[i]);
    axes[i].has_no_place = (!spacings.empty() && !axes[i].spacing) ||
                           (!kinds.empty() && is_unknown(kinds[i])) ||
                           (!centerings.empty() && is_unknown(centerings[i]));
    if (!units.empty()) axes[i].unit = units[i];
    if (directions.empty()) continue;
    axes[i].is_spatial = !is_no_direction(lower_case(directions[i]));
    if (axes[i].is_spatial) axes[i].direction = vector_of(file, directions[i]);
  }
  return axes;
}

std::optional<glm::dvec3> nrrd_to_lps(const TextHeader& text) {
  std::string space = lower_case(text.find("space").value_or(""));
  if (space.ends_with("-time")) space.resize(space.size() - 5);
  if (space == "left-posterior-superior" || space == "lps" || space == "lpst")
    return glm::dvec3(1, 1, 1);
  if (space == "right-anterior-superior" || space == "ras" || space == "rast")
    return glm::dvec3(-1, -1, 1);
  if (space == "left-anterior-superior" || space == "las" || space == "last")
    return glm::dvec3(1, -1, 1);
  return std::nullopt;
}

std::array<std::string, 3> nrrd_space_units(const fs::path& file, const TextHeader& text) {
  const auto field = text.find("spaceunits");
  if (!field) return {};
  const std::vector<std::string> units = quoted_texts_of(*field);
  if (units.size() < 3) {
    refuse(file, "the header's space units are not usable", R"("unit" "unit" "unit")",
           printable(*field));
  }
  return {units[0], units[1], units[2]};
}

glm::dvec3 nrrd_origin(const fs::path& file, const TextHeader& text) {
  const auto origin = text.find("spaceorigin");
  return origin ? vector_of(file, *origin) : glm::dvec3(0.0);
}

}  // namespace cutaway::reading
