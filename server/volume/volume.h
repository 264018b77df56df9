// A loaded volume: voxels, what they measure, and where they are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "volume/geometry.h"

namespace cutaway {

struct ValueRange {
  double minimum = 0.0;
  double maximum = 0.0;
  bool operator==(const ValueRange&) const = default;
};

/// What a listing, a log line and `cutaway info` say of a volume.
struct VolumeDescription {
  std::string id;  ///< stable across restarts and free of spaces: it stands in shared addresses
  std::string title;
  std::string format;    ///< "DICOM", "NIfTI", "NRRD", "MetaImage", "image stack", "phantom"
  std::string modality;  ///< DICOM's code ("CT", "MR"), or "" where the file does not say
  std::string units;     ///< of the values: "HU", a name that the file gives ("BQML"), or "none"
  std::vector<std::string> warnings;
  /// From black to white, as the file wants to be seen; physical values.
  std::optional<ValueRange> window = {};
};

/// Either 16-bit stored values or floats, i fastest, then j, then k.
using Voxels = std::variant<std::vector<std::uint16_t>, std::vector<float>>;

/// Physical value = stored * value_scale + value_offset: Hounsfield units for CT. Rescale slope and
/// intercept of the file are in there exactly once. `value_scale` is above 0, whatever the file's
/// slope: who compares stored values, or takes a gradient of them, may forget the rescale. Every
/// value is finite; voxels for which the file has none hold `nothing_value`. Immutable after
/// loading, so shared between threads.
struct Volume {
  VolumeDescription description;
  VolumeGeometry geometry;
  Voxels voxels;
  double value_scale = 1.0;
  double value_offset = 0.0;
  ValueRange value_range;                    ///< of the physical values
  std::optional<double> nothing_value = {};  ///< below them all; where some voxels have no value
};

/// Physical value at a voxel; the index is clamped to the grid.
double value_at(const Volume& volume, glm::ivec3 index);

/// Trilinear physical value at a continuous index (voxel centres at integers), clamped to the grid.
double sample(const Volume& volume, glm::dvec3 index);

/// Bytes of the voxels as stored.
std::size_t byte_size(const Volume& volume);

}  // namespace cutaway
