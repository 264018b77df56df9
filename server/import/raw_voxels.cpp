#include "import/raw_voxels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/check.h"
#include "core/released_pages.h"
#include "import/no_data.h"
#include "import/refusal.h"
#include "volume/usual_values.h"

namespace cutaway::reading {

namespace {

/// Air in CT is -1000 HU; scanners pad down to about -3100. No other modality stores values there.
bool looks_like_hounsfield(const ValueRange& range) {
  return range.minimum <= -900 && range.minimum >= -3100 && range.maximum >= 200 &&
         range.maximum <= 70000;
}

template <typename T>
void keep_first_components(std::vector<T>& values, std::size_t channels) {
  for (std::size_t i = 0; i < values.size() / channels; ++i) values[i] = values[i * channels];
}

template <typename T>
void keep_luminances(std::vector<T>& values, std::size_t channels) {
  for (std::size_t i = 0; i < values.size() / channels; ++i) {
    const T* pixel = values.data() + i * channels;
    const double luminance = 0.2126 * static_cast<double>(pixel[0]) +
                             0.7152 * static_cast<double>(pixel[1]) +
                             0.0722 * static_cast<double>(pixel[2]);
    values[i] = static_cast<T>(std::is_integral_v<T> ? std::round(luminance) : luminance);
  }
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

void reduce_channels(RawVoxels& voxels, std::size_t channels, Channels meaning) {
  const bool colour = meaning == Channels::colour && channels >= 3;
  std::visit(
      [&](auto& values) {
        colour ? keep_luminances(values, channels) : keep_first_components(values, channels);
        const std::size_t kept = values.size() / channels;
        release_pages(std::as_writable_bytes(std::span(values).subspan(kept)));
        values.resize(kept);
      },
      voxels);
}

namespace {

struct Packed {
  PackedVoxels voxels;
  std::size_t no_data_voxels = 0;  ///< of a number that stands for none
  double no_data_number = 0.0;
};

Packed pack(RawVolume& raw) {
  return std::visit(
      [&]<typename T>(std::vector<T>& values) {
        const std::span<const T> all(values);
        const NoData<T> no_data = find_no_data(all);
        const auto consumed = [&, released = std::size_t{0}](std::size_t done) mutable {
          release_pages(
              std::as_writable_bytes(std::span(values).subspan(released, done - released)));
          released = done;
        };
        Packed packed{pack_voxels<T>(all, raw.slope, raw.intercept, no_data.valid, consumed),
                      no_data.voxels, no_data.number.value_or(0.0)};
        std::vector<T>().swap(values);
        return packed;
      },
      raw.voxels);
}

void warn_of_nothing(const Packed& packed, std::vector<std::string>& warnings) {
  if (!packed.voxels.nothing_value) return;
  const std::string how =
      fmt::format("; what has no value counts as nothing, and was set to {:.6g}, below all values",
                  *packed.voxels.nothing_value);
  const std::size_t not_finite = packed.voxels.nothing_voxels - packed.no_data_voxels;
  if (not_finite > 0) {
    warnings.push_back(
        counted(not_finite, "voxel is not a finite number", "voxels are not finite numbers") + how);
  }
  if (packed.no_data_voxels > 0) {
    warnings.push_back(fmt::format("{} {:.6g}, far from all others",
                                   counted(packed.no_data_voxels, "voxel holds", "voxels hold"),
                                   packed.no_data_number) +
                       how);
  }
}

void warn_of_values(const Volume& volume, const UsualValues& usual,
                    std::vector<std::string>& warnings) {
  const ValueRange& all = volume.value_range;
  if (!(all.maximum > all.minimum) && !volume.nothing_value) {
    warnings.push_back(
        fmt::format("every voxel has the value {:.6g}: the volume is empty", all.minimum));
  }
  if (usual.strays == 0) return;
  warnings.push_back(fmt::format(
      "{} far from all others, which reach from {:.6g} to {:.6g}; what is chosen for "
      "the volume goes by those",
      counted(usual.strays, "voxel lies", "voxels lie"), usual.range.minimum, usual.range.maximum));
}

}  // namespace

Volume finish_volume(RawVolume raw) {
  const auto& size = raw.geometry.size_voxels;
  check_equal(count_of(raw.voxels), std::size_t(size.x) * size.y * size.z, "voxels fill the grid");
  Packed packed = pack(raw);
  warn_of_nothing(packed, raw.description.warnings);
  Volume volume{std::move(raw.description),      raw.geometry,
                std::move(packed.voxels.voxels), packed.voxels.value_scale,
                packed.voxels.value_offset,      packed.voxels.value_range,
                packed.voxels.nothing_value};
  const UsualValues usual = usual_values(volume);
  VolumeDescription& description = volume.description;
  warn_of_values(volume, usual, description.warnings);
  if (description.modality.empty() && description.units == "none" &&
      looks_like_hounsfield(usual.range)) {
    description.modality = "CT";
    description.units = "HU";
    description.warnings.emplace_back(
        "the file names no modality; its values are taken for Hounsfield units of a CT");
  }
  return volume;
}

}  // namespace cutaway::reading
