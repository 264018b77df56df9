#include "import/raw_voxels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/check.h"
#include "volume/voxel_packing.h"

namespace cutaway::reading {

namespace {

/// Air in CT is -1000 HU; scanners pad down to about -3100. No other modality stores values there.
bool looks_like_hounsfield(const ValueRange& range) {
  return range.minimum <= -900 && range.minimum >= -3100 && range.maximum >= 200 &&
         range.maximum <= 70000;
}

template <typename T>
std::vector<T> first_components(const std::vector<T>& values, std::size_t channels) {
  std::vector<T> result(values.size() / channels);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = values[i * channels];
  return result;
}

template <typename T>
std::vector<T> luminances(const std::vector<T>& values, std::size_t channels) {
  std::vector<T> result(values.size() / channels);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const T* pixel = values.data() + i * channels;
    const double luminance = 0.2126 * static_cast<double>(pixel[0]) +
                             0.7152 * static_cast<double>(pixel[1]) +
                             0.0722 * static_cast<double>(pixel[2]);
    result[i] = static_cast<T>(std::is_integral_v<T> ? std::round(luminance) : luminance);
  }
  return result;
}

}  // namespace

std::size_t component_bytes(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    case Component::int32:
    case Component::uint32:
    case Component::float32:
      return 4;
    case Component::float64:
    case Component::int64:
    case Component::uint64:
      break;
  }
  return 8;
}

RawVoxels make_raw_voxels(Component component, std::size_t count) {
  switch (component) {
    case Component::int8:
      return std::vector<std::int8_t>(count);
    case Component::uint8:
      return std::vector<std::uint8_t>(count);
    case Component::int16:
      return std::vector<std::int16_t>(count);
    case Component::uint16:
      return std::vector<std::uint16_t>(count);
    case Component::int32:
      return std::vector<std::int32_t>(count);
    case Component::uint32:
      return std::vector<std::uint32_t>(count);
    case Component::float32:
      return std::vector<float>(count);
    case Component::float64:
    case Component::int64:
    case Component::uint64:
      break;
  }
  return std::vector<double>(count);
}

std::span<std::byte> bytes_of(RawVoxels& voxels) {
  return std::visit([](auto& values) { return std::as_writable_bytes(std::span(values)); }, voxels);
}

std::size_t count_of(const RawVoxels& voxels) {
  return std::visit([](const auto& values) { return values.size(); }, voxels);
}

void swap_byte_order(std::span<std::byte> bytes, std::size_t element_bytes) {
  if (element_bytes < 2) return;
  for (std::size_t i = 0; i + element_bytes <= bytes.size(); i += element_bytes) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + element_bytes));
  }
}

void convert_int64_in_place(std::span<double> values, Component component) {
  for (double& value : values) {
    if (component == Component::int64) {
      value = static_cast<double>(std::bit_cast<std::int64_t>(value));
    } else {
      value = static_cast<double>(std::bit_cast<std::uint64_t>(value));
    }
  }
}

RawVoxels reduce_channels(const RawVoxels& voxels, std::size_t channels, Channels meaning) {
  const bool colour = meaning == Channels::colour && channels >= 3;
  return std::visit(
      [&](const auto& values) -> RawVoxels {
        return colour ? luminances(values, channels) : first_components(values, channels);
      },
      voxels);
}

Volume finish_volume(RawVolume raw) {
  const auto& size = raw.geometry.size_voxels;
  check_equal(count_of(raw.voxels), std::size_t(size.x) * size.y * size.z, "voxels fill the grid");
  PackedVoxels packed = std::visit(
      [&](auto& values) {
        PackedVoxels result =
            pack_voxels(std::span(std::as_const(values)), raw.slope, raw.intercept);
        std::remove_reference_t<decltype(values)>().swap(values);
        return result;
      },
      raw.voxels);
  VolumeDescription& description = raw.description;
  if (packed.replaced_non_finite > 0) {
    description.warnings.push_back(
        fmt::format("{} voxels are not finite numbers; each was set to the smallest value",
                    packed.replaced_non_finite));
  }
  if (description.modality.empty() && description.units == "none" &&
      looks_like_hounsfield(packed.value_range)) {
    description.modality = "CT";
    description.units = "HU";
    description.warnings.emplace_back(
        "the file names no modality; its values are taken for Hounsfield units of a CT");
  }
  return {std::move(description), raw.geometry,        std::move(packed.voxels),
          packed.value_scale,     packed.value_offset, packed.value_range};
}

}  // namespace cutaway::reading
