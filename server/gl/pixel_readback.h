// Pixels on their way from the device to the CPU, without stalling the thread that draws.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/picture.h"
#include "gl/fence.h"
#include "gl/framebuffer.h"

namespace cutaway::gl {

/// One transfer of several attachments into one persistently mapped buffer, guarded by a fence.
class PixelReadback {
 public:
  struct Source {
    const Framebuffer* framebuffer;
    glm::ivec2 size_px;
    int attachment;       ///< colour attachment to read
    int bytes_per_pixel;  ///< 1: the red channel; 4: RGBA
  };

  /// Starts the transfer of all sources, one after the other, rows top first and tightly packed.
  void start(std::span<const Source> sources);

  bool is_pending() const { return fence_.is_set(); }
  /// True once the pixels have arrived; never waits.
  bool is_ready() const { return fence_.is_reached(); }
  /// What its buffer takes on the device.
  std::size_t capacity() const { return capacity_; }
  /// Waits until they have, then copies them out, one plane per source.
  std::vector<PixelPlane> finish();

  PixelReadback() = default;
  PixelReadback(PixelReadback&& other) noexcept { *this = std::move(other); }
  PixelReadback& operator=(PixelReadback&& other) noexcept;

 private:
  void reserve(std::size_t bytes);
  BufferHandle buffer_;
  const std::uint8_t* mapped_ = nullptr;
  std::size_t capacity_ = 0;
  std::vector<PlaneShape> shapes_;  ///< of the transfer that is pending
  Fence fence_;
};

}  // namespace cutaway::gl
