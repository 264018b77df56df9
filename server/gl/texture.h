// Textures with immutable storage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "gl/handle.h"

namespace cutaway::gl {

enum class Filtering { nearest, linear };

/// Of a format in use here.
std::uint64_t texel_bytes(GLenum internal_format);

/// Clamped to the edge. Its format is one of GL's sized internal formats.
class Texture2D {
 public:
  Texture2D() = default;
  Texture2D(GLenum internal_format, glm::ivec2 size_px, Filtering filtering);

  GLuint name() const { return handle_.name(); }
  glm::ivec2 size_px() const { return size_px_; }
  /// What it takes on the device.
  std::uint64_t bytes() const;

 private:
  TextureHandle handle_;
  glm::ivec2 size_px_{0};
  GLenum internal_format_ = 0;
};

/// Its format is one of GL's sized internal formats.
class Texture3D {
 public:
  Texture3D() = default;
  Texture3D(GLenum internal_format, glm::ivec3 size_texels, Filtering filtering);

  GLuint name() const { return handle_.name(); }
  glm::ivec3 size_texels() const { return size_texels_; }

  /// Slices [first, first+count) of `whole`: all texels as the texture's format has them, tightly
  /// packed. Throws std::out_of_range, in every build, where `whole` is of another size or has no
  /// such slices: nothing beside it is read.
  void upload_slices(int first, int count, std::span<const std::byte> whole);

 private:
  TextureHandle handle_;
  glm::ivec3 size_texels_{0};
  GLenum internal_format_ = 0;
};

}  // namespace cutaway::gl
