#include "gl/texture.h"

#include <fmt/format.h>

#include <stdexcept>

#include "core/check.h"
#include "gl/device_memory.h"

namespace cutaway::gl {

namespace {

TextureHandle create_texture(GLenum target, Filtering filtering) {
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  const GLint mode = filtering == Filtering::linear ? GL_LINEAR : GL_NEAREST;
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, mode);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, mode);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
  }
  return TextureHandle(name);
}

/// How texels lie in memory that become those of an internal format without conversion.
struct PackedTexel {
  GLenum format;
  GLenum type;
};

PackedTexel packed_texel(GLenum internal_format) {
  switch (internal_format) {
    case GL_R32F:
      return {GL_RED, GL_FLOAT};
    case GL_RG8UI:
      return {GL_RG_INTEGER, GL_UNSIGNED_BYTE};
    default:
      check_equal(internal_format, GLenum{GL_R16}, "texels of this format are uploaded");
      return {GL_RED, GL_UNSIGNED_SHORT};
  }
}

}  // namespace

std::uint64_t texel_bytes(GLenum internal_format) {
  switch (internal_format) {
    case GL_RGBA32F:
      return 16;
    case GL_RGBA16F:
      return 8;
    case GL_RGBA8:
    case GL_R32F:
    case GL_RG16F:
    case GL_DEPTH_COMPONENT32F:
      return 4;
    case GL_R16:
    case GL_RG8UI:
      return 2;
    default:
      check_equal(internal_format, GLenum{GL_R8}, "the size of each format in use is known");
      return 1;
  }
}

Texture2D::Texture2D(GLenum internal_format, glm::ivec2 size_px, Filtering filtering)
    : handle_(create_texture(GL_TEXTURE_2D, filtering)),
      size_px_(size_px),
      internal_format_(internal_format) {
  glTextureStorage2D(name(), 1, internal_format, size_px.x, size_px.y);
  throw_if_out_of_memory("a picture");
}

std::uint64_t Texture2D::bytes() const {
  if (name() == 0) return 0;
  return std::uint64_t(size_px_.x) * size_px_.y * texel_bytes(internal_format_);
}

Texture3D::Texture3D(GLenum internal_format, glm::ivec3 size_texels, Filtering filtering)
    : handle_(create_texture(GL_TEXTURE_3D, filtering)),
      size_texels_(size_texels),
      internal_format_(internal_format) {
  glTextureStorage3D(name(), 1, internal_format, size_texels.x, size_texels.y, size_texels.z);
}

void Texture3D::upload_slices(int first, int count, std::span<const std::byte> whole) {
  const glm::ivec3 size = size_texels_;
  const std::size_t slice_bytes = texel_bytes(internal_format_) * std::size_t(size.x) * size.y;
  if (whole.size() != slice_bytes * size.z) {
    throw std::out_of_range(fmt::format("{} bytes are not {} x {} x {} texels of {}", whole.size(),
                                        size.x, size.y, size.z, texel_bytes(internal_format_)));
  }
  if (first < 0 || count < 0 || count > size.z - first) {
    throw std::out_of_range(
        fmt::format("{} slices from {} on are not among {}", count, first, size.z));
  }
  const PackedTexel texel = packed_texel(internal_format_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage3D(name(), 0, 0, 0, first, size.x, size.y, count, texel.format, texel.type,
                      whole.subspan(slice_bytes * first).data());
}

}  // namespace cutaway::gl
