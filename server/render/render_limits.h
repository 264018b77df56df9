// What the render thread may take of the device.
#pragma once

#include <cstdint>

namespace cutaway {

struct RenderLimits {
  std::uint64_t volume_bytes = 0;  ///< textures of volumes; 0: by the device
  std::uint64_t view_bytes = 0;    ///< buffers of views; 0: by the device
  /// How much of one frame is drawn before another has its turn, in pixels of a simple pass (a ray
  /// costs four); 0: by the device.
  std::int64_t step = 0;

  bool operator==(const RenderLimits&) const = default;
};

/// With what was left to the device filled in: a software renderer's textures lie in the machine's
/// memory, beside the volumes themselves.
RenderLimits limits_for(const RenderLimits& wanted, bool is_software, std::uint64_t machine_bytes);

}  // namespace cutaway
