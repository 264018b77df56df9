#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "import/data_root.h"
#include "import/grids/grid_file.h"
#include "import/grids/nrrd_header.h"
#include "import/length_unit.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

std::int64_t whole_number(const fs::path& file, const TextHeader& text, const char* name) {
  const auto number = integer_of(text.find(name).value_or("0"));
  if (number && *number >= -1 && *number < std::int64_t{1} << 40) return *number;
  refuse(file, fmt::format("the header's {} is not usable", name), "a whole number",
         printable(text.find(name).value_or("")));
}

/// Where the data begin: behind the header, and then behind the lines that it says to pass over.
std::uint64_t begin_of_data(const fs::path& data, std::uint64_t header_bytes, std::int64_t lines) {
  std::ifstream input(data, std::ios::binary);
  input.seekg(static_cast<std::streamoff>(header_bytes));
  for (std::int64_t i = 0; i < lines && input; ++i) {
    input.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  const auto position = input.tellg();
  if (position < 0) refuse(data, "the file ends before its voxels begin");
  return static_cast<std::uint64_t>(position);
}

void set_data(GridFile& grid, const TextHeader& text, const fs::path& root) {
  VoxelData& data = grid.data;
  data.component = nrrd_component(grid.header, text);
  data.encoding = nrrd_encoding(grid.header, text);
  const auto named = text.find("datafile");
  data.files = named ? named_data_files(grid.header, *named, text, root) : std::vector{grid.header};
  data.begin = begin_of_data(data.files.front(), named ? 0 : text.bytes,
                             whole_number(grid.header, text, "lineskip"));
  const std::int64_t skip = whole_number(grid.header, text, "byteskip");
  data.at_end_of_file = skip < 0;
  data.skip_decoded = skip < 0 ? 0 : static_cast<std::uint64_t>(skip);
  const std::string endian = lower_case(text.find("endian").value_or(""));
  const bool matters = data.encoding != Encoding::ascii && component_bytes(data.component) > 1;
  if (matters && endian != "little" && endian != "big") {
    refuse(grid.header, "the header does not say the byte order", "endian: little or big",
           printable(endian));
  }
  data.swapped = matters && is_swapped(endian == "big");
  if (data.at_end_of_file && data.encoding != Encoding::raw) {
    refuse(grid.header, "a byte skip of -1 needs raw data", "encoding: raw");
  }
}

/// Where there are more than three: those that the header gives no place are none of space, if that
/// leaves three; without any hint the first three are.
void guess_spatial_axes(const TextHeader& text, std::vector<NrrdAxis>& axes) {
  const auto is_placed = [](const NrrdAxis& axis) { return axis.is_spatial && !axis.has_no_place; };
  if (std::ranges::count_if(axes, &NrrdAxis::is_spatial) <= 3) return;
  if (std::ranges::count_if(axes, is_placed) == 3) {
    for (NrrdAxis& axis : axes) axis.is_spatial = is_placed(axis);
    return;
  }
  if (text.find("kinds") || text.find("spacedirections")) return;
  for (std::size_t i = 3; i < axes.size(); ++i) axes[i].is_spatial = false;
}

/// Channels come before the axes of space, times after them.
void set_axes(GridFile& grid, std::vector<NrrdAxis>& axes, const ImportLimits& limits) {
  const auto spatial = [](const NrrdAxis& axis) { return axis.is_spatial; };
  const auto first = std::find_if(axes.begin(), axes.end(), spatial);
  const auto last = std::find_if_not(first, axes.end(), spatial);
  if (last - first != 3 || std::count_if(axes.begin(), axes.end(), spatial) != 3) {
    refuse(grid.header, "the array has not three neighbouring axes of space", "3",
           fmt::format("{} of {}", std::count_if(axes.begin(), axes.end(), spatial), axes.size()));
  }
  std::int64_t channels = 1;
  for (auto axis = axes.begin(); axis != first; ++axis) {
    if (axis->extent < 1 || axis->extent > 4096 / channels) {
      refuse(grid.header, "the number of values at a voxel is not usable", "1 to 4096",
             std::to_string(axis->extent));
    }
    channels *= axis->extent;
    if (axis->is_colour) grid.meaning = Channels::colour;
  }
  grid.channels = static_cast<std::size_t>(channels);
  std::vector<std::int64_t> extents;
  for (auto axis = first; axis != axes.end(); ++axis) extents.push_back(axis->extent);
  set_extents(grid, extents, limits);
  axes.erase(last, axes.end());
  axes.erase(axes.begin(), first);
}

/// A unit that is not said is millimetres by custom; one that is not known is taken for them.
double millimetres_of(const std::string& unit, std::vector<std::string>& warnings) {
  if (unit.empty()) return 1.0;
  if (const auto millimetres = millimetres_per(unit)) return *millimetres;
  std::string warning = fmt::format(
      "the unit of length \"{}\" is not known; millimetres were taken", printable(unit));
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) {
    warnings.push_back(std::move(warning));
  }
  return 1.0;
}

/// What the header leaves open of the place in the patient, and what was taken; empty for nothing.
std::string assumed_place(const TextHeader& text, bool spaced) {
  const std::string space = printable(text.find("space").value_or(""));
  const bool patient_space = nrrd_to_lps(text).has_value();
  const char* const spacing = spaced ? "" : ", spacing as 1 mm";
  if (text.find("spacedirections")) {
    if (patient_space) return "";
    return fmt::format(
        "the file places its voxels in {}; that was taken for the patient's "
        "left-posterior-superior",
        space.empty() ? "a space without a name" : "the space \"" + space + "\"");
  }
  if (patient_space) {
    return fmt::format(
        "the file gives no space directions; i, j, k taken along the axes of its space, {}{}",
        space, spacing);
  }
  return fmt::format(
      "no physical geometry: the file names no place in the patient; i, j, k taken as left, "
      "posterior, superior{}",
      spacing);
}

/// Directions of length 1 in a space without name and unit say no more than that the voxels are
/// cubes: whoever wrote them had no spacing to say.
bool tells_no_spacing(const TextHeader& text, const std::vector<NrrdAxis>& axes) {
  constexpr double kRounding = 1e-6;
  if (text.find("space") || text.find("spaceunits")) return false;
  return std::ranges::all_of(axes, [](const NrrdAxis& axis) {
    return axis.direction && std::abs(glm::length(*axis.direction) - 1.0) < kRounding;
  });
}

/// "space units" are of directions and origin, "units" of each axis' own spacing.
void set_place(GridFile& grid, const TextHeader& text, const std::vector<NrrdAxis>& axes) {
  const glm::dvec3 to_lps = nrrd_to_lps(text).value_or(glm::dvec3(1.0));
  const auto units = nrrd_space_units(grid.header, text);
  glm::dvec3 to_lps_mm = to_lps;
  for (int i = 0; i < 3; ++i)
    to_lps_mm[i] *= millimetres_of(units.at(static_cast<std::size_t>(i)), grid.warnings);
  bool spaced = true;
  for (int axis = 0; axis < 3; ++axis) {
    const NrrdAxis& from = axes[static_cast<std::size_t>(axis)];
    spaced = spaced && (from.direction || from.spacing);
    glm::dvec3 step_mm(0.0);
    if (!from.direction)
      step_mm[axis] = from.spacing.value_or(1.0) * millimetres_of(from.unit, grid.warnings);
    grid.steps_mm[axis] = from.direction ? *from.direction * to_lps_mm : step_mm * to_lps;
  }
  grid.origin_mm = nrrd_origin(grid.header, text) * to_lps_mm;
  if (std::string assumed = assumed_place(text, spaced); !assumed.empty())
    grid.warnings.push_back(std::move(assumed));
  if (tells_no_spacing(text, axes)) {
    grid.warnings.push_back(
        "no physical spacing: the header's directions have length 1 and no unit; spacing taken as "
        "1 mm");
  }
}

}  // namespace

GridFile open_nrrd(const fs::path& file, const fs::path& root, const ImportLimits& limits) {
  const TextHeader text = parse_nrrd_header(file);
  GridFile grid;
  grid.header = file;
  grid.format = "NRRD";
  grid.units = quoted_briefly(printable(text.find("sampleunits").value_or("")));
  set_data(grid, text, root);
  std::vector<NrrdAxis> axes = nrrd_axes(file, text);
  guess_spatial_axes(text, axes);
  set_axes(grid, axes, limits);
  set_place(grid, text, axes);
  return grid;
}

}  // namespace cutaway::reading
