// volume.json beside a stack of pictures: what pictures cannot say of themselves.
#pragma once

#include <filesystem>
#include <optional>

#include "import/raw_voxels.h"

namespace cutaway::reading {

inline constexpr const char* kSidecarName = "volume.json";

/// Every field may be absent.
struct Sidecar {
  std::optional<std::string> title;
  std::optional<std::string> modality;
  std::optional<std::string> units;  ///< "HU" or "none"
  std::optional<glm::dvec3> spacing_mm;
  glm::dvec3 origin_lps_mm{0.0};
  glm::dmat3 direction_lps{1.0};  ///< in the file row-major; columns are the axes
  double slope = 1.0;
  double intercept = 0.0;
  std::vector<std::string> warnings;  ///< of fields that are not known
};

/// Throws Error naming the file and the field for anything that is not usable, or nested deeper
/// than its fields are.
Sidecar read_sidecar(const std::filesystem::path& file);

}  // namespace cutaway::reading
