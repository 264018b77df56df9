// The NIfTI-1 and NIfTI-2 headers.
// Sources: R. Cox et al., nifti1.h (NIfTI-1 Data Format, 2004); nifti2.h (NIfTI-2, 2011).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include "import/raw_voxels.h"

namespace cutaway::reading {

struct NiftiHeader {
  bool swapped = false;     ///< the file's byte order is not ours
  bool single_file = true;  ///< "n+1", "n+2"; else the voxels are in an .img beside it
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  std::array<double, 8> pixdim{};
  std::uint64_t voxel_offset = 0;
  double slope = 0.0;
  double intercept = 0.0;
  int length_unit = 0;  ///< 1 metre, 2 millimetre, 3 micrometre, 0 not said
  int qform_code = 0;
  int sform_code = 0;
  std::array<double, 3> quaternion_bcd{};
  std::array<double, 3> qform_offset{};
  std::array<double, 12> sform{};  ///< three rows of four
};

/// Throws Error naming `file` where `bytes` (the file's first 540, or all of it if shorter) are no
/// NIfTI header.
NiftiHeader parse_nifti_header(const std::filesystem::path& file, std::span<const std::byte> bytes);

struct NiftiAffine {
  glm::dmat3 steps_mm{1.0};  ///< columns: LPS mm from a voxel to the next along i, j, k
  glm::dvec3 origin_mm{0.0};
  std::vector<std::string> warnings;
};

/// sform where it is set and usable, else qform (with a warning where both are set), else pixdim
/// alone with a warning; RAS in the file's length unit to LPS mm. Throws Error naming `file` where
/// the chosen one is not finite or its spacing is not positive.
NiftiAffine nifti_affine(const std::filesystem::path& file, const NiftiHeader& header);

struct NiftiVoxelType {
  Component component = Component::uint8;
  std::size_t channels = 1;  ///< 3 or 4: colour
};

/// Throws Error naming `file` for complex, binary and extended types.
NiftiVoxelType nifti_voxel_type(const std::filesystem::path& file, const NiftiHeader& header);

}  // namespace cutaway::reading
