// The NRRD header.
// Source: G. Kindlmann, "Definition of NRRD File Format", teem.sourceforge.net/nrrd/format.html.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "import/grids/voxel_data.h"
#include "import/raw_voxels.h"
#include "import/text_header.h"

namespace cutaway::reading {

/// Fields by their lower-case name without blanks ("spacedirections"); `further_lines` after "data
/// file: LIST". Throws Error naming the file.
TextHeader parse_nrrd_header(const std::filesystem::path& file);

Component nrrd_component(const std::filesystem::path& file, const TextHeader& text);
Encoding nrrd_encoding(const std::filesystem::path& file, const TextHeader& text);

/// One axis of the array; one without a place in space holds channels or times.
struct NrrdAxis {
  std::int64_t extent = 0;
  bool is_spatial = true;
  bool is_colour = false;
  bool has_no_place = false;            ///< by an unknown spacing, kind or centering
  std::optional<double> spacing;        ///< from "spacings", in `unit`
  std::string unit;                     ///< from "units"; empty where it is not said
  std::optional<glm::dvec3> direction;  ///< from "space directions", in the file's own space
};

/// Throws Error naming the file for extents, spacings and directions that are not usable, or lists
/// that are not as long as the dimension.
std::vector<NrrdAxis> nrrd_axes(const std::filesystem::path& file, const TextHeader& text);

/// Factors from the file's space to LPS; nothing where it names none of the patient's.
std::optional<glm::dvec3> nrrd_to_lps(const TextHeader& text);

/// Of the space's first three axes, "space units"; empty where they are not said. Throws Error
/// naming the file for less than three.
std::array<std::string, 3> nrrd_space_units(const std::filesystem::path& file,
                                            const TextHeader& text);

/// In the file's own space and units.
glm::dvec3 nrrd_origin(const std::filesystem::path& file, const TextHeader& text);

}  // namespace cutaway::reading
