// MetaImage: itk.org/Wiki/ITK/MetaIO/Documentation.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/data_root.h"
#include "import/grids/grid_file.h"
#include "import/refusal.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// Fields up to and with ElementDataFile, which ends the header; a list of data files follows it.
TextHeader parse_text(const fs::path& file) {
  HeaderLines lines(file);
  TextHeader header;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const std::size_t equals = line->find_first_of("=:");
    if (equals == std::string::npos)
      refuse(file, "not a MetaImage header: a line is no field", "Name = value");
    const std::string name(trimmed(std::string_view(*line).substr(0, equals)));
    header.fields[name] = trimmed(std::string_view(*line).substr(equals + 1));
    if (name != "ElementDataFile") continue;
    header.bytes = lines.position();
    const bool list = header.fields[name].starts_with("LIST");
    while (auto listed = list ? lines.next() : std::nullopt) {
      if (!trimmed(*listed).empty()) header.further_lines.emplace_back(trimmed(*listed));
    }
    return header;
  }
  refuse(file, "not a MetaImage header", "a field ElementDataFile");
}

class MetaFields {
 public:
  MetaFields(const fs::path& file, const TextHeader& text) : file_(file), text_(text) {}

  std::string word(std::string_view name, std::string_view otherwise = "") const {
    return text_.find(name).value_or(std::string(otherwise));
  }

  bool flag(std::string_view name, bool otherwise = false) const {
    const std::string value = lower_case(word(name));
    return value.empty() ? otherwise : value.starts_with('t') || value.starts_with('1');
  }

  std::int64_t integer(const char* name, std::int64_t otherwise, std::int64_t low,
                       std::int64_t high) const {
    if (!text_.find(name)) return otherwise;
    const auto value = integer_of(word(name));
    if (value && *value >= low && *value <= high) return *value;
    refuse(file_, fmt::format("the header's {} is not usable", name),
           fmt::format("{} to {}", low, high), printable(word(name)));
  }

  /// The first of the fields that is there; exactly `count` finite numbers. MetaIO itself takes
  /// what is unusable for 1 or 0.
  std::optional<std::vector<double>> numbers(std::initializer_list<const char*> names,
                                             std::size_t count, bool positive = false) const {
    for (const char* name : names) {
      if (!text_.find(name)) continue;
      std::vector<double> values = numbers_of(word(name));
      const bool usable =
          values.size() == count && std::all_of(values.begin(), values.end(), [&](double v) {
            return std::isfinite(v) && (!positive || v > 0);
          });
      if (usable) return values;
      refuse(file_, fmt::format("the header's {} is not usable", name),
             fmt::format("{} {}", count, positive ? "numbers above 0" : "finite numbers"),
             printable(word(name)));
    }
    return std::nullopt;
  }

 private:
  const fs::path& file_;
  const TextHeader& text_;
};

Component component_of(const fs::path& file, const MetaFields& fields) {
  // MetaIO's LONG is of 4 bytes everywhere.
  constexpr std::array<std::pair<std::string_view, Component>, 12> kTypes{
      {{"MET_CHAR", Component::int8},
       {"MET_UCHAR", Component::uint8},
       {"MET_SHORT", Component::int16},
       {"MET_USHORT", Component::uint16},
       {"MET_INT", Component::int32},
       {"MET_UINT", Component::uint32},
       {"MET_LONG", Component::int32},
       {"MET_ULONG", Component::uint32},
       {"MET_LONG_LONG", Component::int64},
       {"MET_ULONG_LONG", Component::uint64},
       {"MET_FLOAT", Component::float32},
       {"MET_DOUBLE", Component::float64}}};
  const std::string type = fields.word("ElementType");
  // An array is as long as ElementNumberOfChannels says, like the values of any other type.
  constexpr std::string_view kArray = "_ARRAY";
  std::string_view element = type;
  if (element.ends_with(kArray)) element.remove_suffix(kArray.size());
  const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const auto& entry) { return entry.first == element; });
  if (found != kTypes.end()) return found->second;
  refuse(file, "this number type is not read", "MET_CHAR to MET_DOUBLE", printable(type));
}

void set_data(GridFile& grid, const TextHeader& text, const MetaFields& fields,
              const fs::path& root) {
  VoxelData& data = grid.data;
  data.component = component_of(grid.header, fields);
  grid.channels = static_cast<std::size_t>(fields.integer("ElementNumberOfChannels", 1, 1, 4096));
  const std::string named = fields.word("ElementDataFile");
  const bool attached = lower_case(named) == "local";
  data.files =
      attached ? std::vector{grid.header} : named_data_files(grid.header, named, text, root);
  data.begin = attached ? text.bytes : 0;
  const std::int64_t skip = fields.integer("HeaderSize", 0, -1, std::int64_t{1} << 40);
  data.at_end_of_file = skip < 0;
  if (skip > 0) data.begin += static_cast<std::uint64_t>(skip);
  data.encoding = fields.flag("CompressedData")     ? Encoding::deflated
                  : fields.flag("BinaryData", true) ? Encoding::raw
                                                    : Encoding::ascii;
  data.swapped =
      is_swapped(fields.flag("BinaryDataByteOrderMSB", fields.flag("ElementByteOrderMSB")));
  if (data.at_end_of_file && data.encoding != Encoding::raw) {
    refuse(grid.header, "a HeaderSize of -1 needs raw data", "CompressedData = False");
  }
}

std::vector<std::int64_t> set_axes(GridFile& grid, const MetaFields& fields,
                                   const ImportLimits& limits) {
  const auto axes = static_cast<std::size_t>(fields.integer("NDims", 0, 1, 10));
  std::vector<std::int64_t> extents;
  for (const auto& word : words_of(fields.word("DimSize")))
    extents.push_back(integer_of(word).value_or(0));
  if (extents.size() != axes || axes == 0) {
    refuse(grid.header, "the header's DimSize is not usable",
           fmt::format("NDims = {} numbers", axes), printable(fields.word("DimSize")));
  }
  set_extents(grid, extents, limits);
  return extents;
}

/// TransformMatrix holds one axis of the grid a row.
void set_place(GridFile& grid, const MetaFields& fields, std::size_t axes) {
  const auto spacing = fields.numbers({"ElementSpacing", "ElementSize"}, axes, true);
  const auto origin = fields.numbers({"Offset", "Position", "Origin"}, axes);
  const auto matrix = fields.numbers({"TransformMatrix", "Rotation", "Orientation"}, axes * axes);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    if (matrix) direction = {(*matrix)[i * axes], (*matrix)[i * axes + 1], (*matrix)[i * axes + 2]};
    if (std::abs(glm::length(direction) - 1) > 1e-3) {
      refuse(grid.header, "the header's TransformMatrix is not usable", "rows of length 1",
             number_in_words(glm::length(direction)));
    }
    grid.steps_mm[axis] = direction * (spacing ? (*spacing)[i] : 1.0);
    if (origin) grid.origin_mm[axis] = (*origin)[i];
  }
  if (!spacing) grid.warnings.emplace_back("the file gives no spacing; 1 mm was taken");
}

/// "MET_MOD_CT" to DICOM's "CT".
std::string modality_of(const MetaFields& fields) {
  const std::string named = fields.word("Modality");
  for (const char* known : {"CT", "MR", "NM", "US"}) {
    if (named == std::string("MET_MOD_") + known) return known;
  }
  return "";
}

}  // namespace

GridFile open_metaimage(const fs::path& file, const fs::path& root, const ImportLimits& limits) {
  const TextHeader text = parse_text(file);
  const MetaFields fields(file, text);
  GridFile grid;
  grid.header = file;
  grid.format = "MetaImage";
  grid.modality = modality_of(fields);
  set_data(grid, text, fields, root);
  grid.meaning = grid.channels == 3 || grid.channels == 4 ? Channels::colour : Channels::components;
  const auto extents = set_axes(grid, fields, limits);
  set_place(grid, fields, extents.size());
  const double slope =
      fields.numbers({"ElementToIntensityFunctionSlope"}, 1).value_or(std::vector{1.0})[0];
  grid.intercept =
      fields.numbers({"ElementToIntensityFunctionOffset"}, 1).value_or(std::vector{0.0})[0];
  grid.slope = slope == 0 ? 1.0 : slope;
  return grid;
}

}  // namespace cutaway::reading
