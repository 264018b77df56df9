// NIfTI files for tests, field by field from the format's definition, so that the reader is checked
// against that.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cutaway::test {

struct NiftiFile {
  int version = 1;
  bool big_endian = false;
  std::string magic = "n+1";
  std::vector<std::int64_t> dim{4, 5, 6};
  std::int16_t datatype = 16;
  std::vector<double> pixdim{1, 1, 1, 1, 1, 1, 1, 1};
  std::optional<double> voxel_offset;  ///< declared; else where the voxels are
  double slope = 0;
  double intercept = 0;
  int units = 2;
  int qform_code = 0;
  int sform_code = 1;
  glm::dvec3 quaternion{0, 0, 0};
  glm::dvec3 q_offset{0, 0, 0};
  glm::dmat3 s_steps{1};  ///< RAS
  glm::dvec3 s_origin{0, 0, 0};

  /// With the four bytes behind it that announce no extension.
  std::string header() const;

  /// A ramp over the grid that the sform describes, as floats.
  std::string ramp_voxels() const;

  std::string with(const std::string& voxels) const { return header() + voxels; }
};

}  // namespace cutaway::test
