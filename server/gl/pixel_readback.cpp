#include "gl/pixel_readback.h"

#include <utility>

#include "core/check.h"
#include "gl/device_memory.h"

namespace cutaway::gl {

PixelReadback& PixelReadback::operator=(PixelReadback&& other) noexcept {
  std::swap(buffer_, other.buffer_);
  std::swap(mapped_, other.mapped_);
  std::swap(capacity_, other.capacity_);
  std::swap(sizes_, other.sizes_);
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
  sizes_.clear();
  std::size_t total = 0;
  for (const Source& source : sources) {
    sizes_.push_back(static_cast<std::size_t>(source.size_px.x) * source.size_px.y *
                     source.bytes_per_pixel);
    total += sizes_.back();
  }
  reserve(total);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
  std::size_t offset = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Source& source = sources[i];
    glNamedFramebufferReadBuffer(source.framebuffer->name(),
                                 GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(source.attachment));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.framebuffer->name());
    glReadPixels(
        0, 0, source.size_px.x, source.size_px.y, source.format, GL_UNSIGNED_BYTE,
        reinterpret_cast<void*>(offset));  // NOLINT(performance-no-int-to-ptr): GL's own way
    offset += sizes_[i];
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = Fence::insert();
}

std::vector<std::vector<std::uint8_t>> PixelReadback::finish() {
  check(is_pending(), "a transfer is pending");
  fence_.wait();
  fence_ = Fence();
  std::vector<std::vector<std::uint8_t>> pixels;
  const std::uint8_t* from = mapped_;
  for (const std::size_t size : sizes_) {
    pixels.emplace_back(from, from + size);
    from += size;
  }
  return pixels;
}

}  // namespace cutaway::gl
