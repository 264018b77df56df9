#include "import/pictures/sidecar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

using Json = nlohmann::json;

class Reader {
 public:
  Reader(const std::filesystem::path& file, const Json& object) : file_(file), object_(object) {}

  std::optional<std::string> text(const char* name) const {
    if (!object_.contains(name)) return std::nullopt;
    if (!object_[name].is_string()) refuse_field(name, "a text");
    return quoted_briefly(printable(object_[name].get<std::string>()));
  }

  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const char* name, const char* expected) const {
    if (!object_.contains(name)) return std::nullopt;
    const Json& value = object_[name];
    const bool usable =
        value.is_array() && value.size() == N &&
        std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
    if (!usable) refuse_field(name, expected);
    return value.get<std::array<double, N>>();
  }

  double number(const char* name, double otherwise) const {
    if (!object_.contains(name)) return otherwise;
    if (!object_[name].is_number()) refuse_field(name, "a number");
    return object_[name].get<double>();
  }

  [[noreturn]] void refuse_field(const std::string& name, const char* expected) const {
    refuse(file_, "the field " + name + " is not usable", expected,
           object_.contains(name)
               ? object_[name].dump(-1, ' ', false, Json::error_handler_t::replace)
               : "");
  }

 private:
  const std::filesystem::path& file_;
  const Json& object_;
};

/// What nests deeper is built nowhere: a field is also printed, by recursion.
Json parse(const std::filesystem::path& file) {
  constexpr int kDeepestNesting = 4;
  constexpr std::size_t kLargestBytes = 65536;
  std::ifstream input(file, std::ios::binary);
  std::string text(kLargestBytes + 1, '\0');
  input.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(input.gcount()));
  if (text.size() > kLargestBytes) refuse(file, "the file is too long", "at most 64 KiB");
  bool too_deep = false;
  const auto is_shallow = [&](int depth, Json::parse_event_t, const Json&) {
    too_deep = too_deep || depth > kDeepestNesting;
    return depth <= kDeepestNesting;
  };
  Json object = Json::parse(text, is_shallow, false);
  if (too_deep) refuse(file, "the file is nested too deeply", "lists in an object, no deeper");
  if (!object.is_object()) refuse(file, "the file is not usable", "a JSON object");
  return object;
}

void read_spacing(const Reader& reader, Sidecar& sidecar) {
  const auto spacing = reader.numbers<3>("spacing_mm", "three numbers above 0");
  if (!spacing) return;
  if (std::any_of(spacing->begin(), spacing->end(), [](double s) { return !(s > 0) || s > 1e4; })) {
    reader.refuse_field("spacing_mm", "three numbers above 0, in mm");
  }
  sidecar.spacing_mm = glm::dvec3((*spacing)[0], (*spacing)[1], (*spacing)[2]);
}

void read_placement(const Reader& reader, Sidecar& sidecar) {
  if (const auto origin = reader.numbers<3>("origin_lps_mm", "three numbers")) {
    sidecar.origin_lps_mm = {(*origin)[0], (*origin)[1], (*origin)[2]};
  }
  const auto direction = reader.numbers<9>("direction_lps", "nine numbers, row-major");
  if (!direction) return;
  auto value = direction->begin();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) sidecar.direction_lps[column][row] = *value++;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(sidecar.direction_lps[axis]);
    if (!(std::abs(length - 1) < 1e-3)) reader.refuse_field("direction_lps", "columns of length 1");
  }
}

void read_rescale(const std::filesystem::path& file, const Json& object, Sidecar& sidecar) {
  if (!object.contains("rescale")) return;
  if (!object["rescale"].is_object())
    refuse(file, "the field rescale is not usable", "slope and intercept");
  const Reader reader(file, object["rescale"]);
  sidecar.slope = reader.number("slope", 1.0);
  sidecar.intercept = reader.number("intercept", 0.0);
  if (sidecar.slope == 0) reader.refuse_field("slope", "a number other than 0");
}

void warn_of_unknown(const Json& object, Sidecar& sidecar) {
  constexpr std::array kKnown{"title",         "modality", "spacing_mm", "origin_lps_mm",
                              "direction_lps", "rescale",  "units"};
  constexpr std::size_t kMostNamed = 8;
  std::size_t unknown = 0;
  for (const auto& [name, value] : object.items()) {
    if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
    if (++unknown > kMostNamed) continue;
    sidecar.warnings.push_back("volume.json: the field " + quoted_briefly(printable(name)) +
                               " is not known and was left out");
  }
  if (unknown > kMostNamed) {
    sidecar.warnings.push_back("volume.json: so were " + std::to_string(unknown - kMostNamed) +
                               " more fields");
  }
}

}  // namespace

Sidecar read_sidecar(const std::filesystem::path& file) {
  const Json object = parse(file);
  const Reader reader(file, object);
  Sidecar sidecar;
  sidecar.title = reader.text("title");
  sidecar.modality = reader.text("modality");
  sidecar.units = reader.text("units");
  if (sidecar.units && *sidecar.units != "HU" && *sidecar.units != "none") {
    reader.refuse_field("units", "\"HU\" or \"none\"");
  }
  read_spacing(reader, sidecar);
  read_placement(reader, sidecar);
  read_rescale(file, object, sidecar);
  warn_of_unknown(object, sidecar);
  return sidecar;
}

}  // namespace cutaway::reading
