#include "gl/pixel_readback.h"

#include <utility>

#include "core/check.h"
#include "gl/device_memory.h"

namespace cutaway::gl {

namespace {

GLenum format_of(const PixelReadback::Source& source) {
  check(source.bytes_per_pixel == 1 || source.bytes_per_pixel == 4, "a pixel is red or RGBA");
  return source.bytes_per_pixel == 1 ? GL_RED : GL_RGBA;
}

}  // namespace

PixelReadback& PixelReadback::operator=(PixelReadback&& other) noexcept {
  std::swap(buffer_, other.buffer_);
  std::swap(mapped_, other.mapped_);
  std::swap(capacity_, other.capacity_);
  std::swap(shapes_, other.shapes_);
  std::swap(fence_, other.fence_);
  return *this;
}

void PixelReadback::reserve(std::size_t bytes) {
  if (bytes <= capacity_) return;
  GLuint name = 0;
  glCreateBuffers(1, &name);
  buffer_ = BufferHandle(name);
  constexpr GLbitfield kMapping = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const auto size = static_cast<GLsizeiptr>(bytes);
  glNamedBufferStorage(name, size, nullptr, kMapping | GL_CLIENT_STORAGE_BIT);
  mapped_ = static_cast<const std::uint8_t*>(glMapNamedBufferRange(name, 0, size, kMapping));
  if (mapped_ == nullptr) throw_out_of_memory("reading a picture back");
  capacity_ = bytes;
}

void PixelReadback::start(std::span<const Source> sources) {
  check(!is_pending(), "no transfer is pending");
  shapes_.clear();
  std::size_t total = 0;
  for (const Source& source : sources) {
    shapes_.push_back({source.size_px, source.bytes_per_pixel});
    total += packed_bytes(source.size_px, source.bytes_per_pixel);
  }
  reserve(total);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
  std::size_t offset = 0;
  for (const Source& source : sources) {
    glNamedFramebufferReadBuffer(source.framebuffer->name(),
                                 GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(source.attachment));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.framebuffer->name());
    glReadPixels(
        0, 0, source.size_px.x, source.size_px.y, format_of(source), GL_UNSIGNED_BYTE,
        reinterpret_cast<void*>(offset));  // NOLINT(performance-no-int-to-ptr): GL's own way
    offset += packed_bytes(source.size_px, source.bytes_per_pixel);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = Fence::insert();
}

std::vector<PixelPlane> PixelReadback::finish() {
  check(is_pending(), "a transfer is pending");
  fence_.wait();
  fence_ = Fence();
  std::vector<PixelPlane> planes;
  std::span<const std::uint8_t> rest(mapped_, capacity_);
  for (const PlaneShape& shape : shapes_) {
    const std::size_t bytes = packed_bytes(shape.size_px, shape.bytes_per_pixel);
    check(bytes <= rest.size(), "the transfer lies in its buffer");
    planes.emplace_back(shape.size_px, shape.bytes_per_pixel, rest.first(bytes));
    rest = rest.subspan(bytes);
  }
  return planes;
}

}  // namespace cutaway::gl
