// Voxels in the number type of their file, on their way to a Volume.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "volume/volume.h"

namespace cutaway::reading {

/// Number types that files hold. 64-bit integers become doubles as they are read.
enum class Component { int8, uint8, int16, uint16, int32, uint32, float32, float64, int64, uint64 };

using RawVoxels =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<float>, std::vector<double>>;

std::size_t component_bytes(Component component);

/// Zeroed voxels of that type; double for the 64-bit integers.
RawVoxels make_raw_voxels(Component component, std::size_t count);

std::span<std::byte> bytes_of(RawVoxels& voxels);
std::size_t count_of(const RawVoxels& voxels);

/// Reverses the bytes of each element of `element_bytes` bytes.
void swap_byte_order(std::span<std::byte> bytes, std::size_t element_bytes);

/// Turns the bit patterns of 64-bit integers, as read into doubles, into their values.
void convert_int64_in_place(std::span<double> values, Component component);

/// What several values at one voxel are.
enum class Channels { colour, components };

/// From interleaved channels to one: colour to its luminance (ITU-R BT.709 weights), else the first
/// component. In place: what the others took is given back.
void reduce_channels(RawVoxels& voxels, std::size_t channels, Channels meaning);

/// Stored voxels with what a file says of them.
struct RawVolume {
  VolumeDescription description;
  VolumeGeometry geometry;
  RawVoxels voxels;
  double slope = 1.0;
  double intercept = 0.0;
};

/// Packs the voxels; warns of those that have no value or a stray one; calls a volume without
/// modality CT where its values are plainly Hounsfield units, and says so in a warning. Throws
/// Error where no value is finite.
Volume finish_volume(RawVolume raw);

}  // namespace cutaway::reading
