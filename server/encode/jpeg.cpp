#include "encode/jpeg.h"

#include <turbojpeg.h>

#include <array>
#include <memory>
#include <string>

#include "core/error.h"

namespace cutaway {

namespace {

struct DestroyCompressor {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Compressor = std::unique_ptr<void, DestroyCompressor>;

/// One a thread: making one costs more than a small frame.
void* thread_compressor() {
  thread_local const Compressor compressor(tjInitCompress());
  return compressor.get();
}

Error refused() {
  return Error({.code = ErrorCode::internal,
                .message = std::string("JPEG: ") + tjGetErrorStr2(thread_compressor())});
}

std::vector<std::uint8_t> room_for(glm::ivec2 size_px, int sampling) {
  constexpr auto kNoSuchSize = static_cast<unsigned long>(-1);
  const unsigned long bytes = tjBufSize(size_px.x, size_px.y, sampling);
  if (bytes == kNoSuchSize) throw refused();
  return std::vector<std::uint8_t>(bytes);
}

}  // namespace

JpegPicture encode_jpeg(const Picture& picture, int quality) {
  if (picture.layout() == PixelLayout::rgba)
    throw Error(
        {.code = ErrorCode::internal, .message = "JPEG: it is made from YCbCr and not from RGBA"});
  const glm::ivec2 size_px = picture.size_px();
  const int sampling = picture.layout() == PixelLayout::yuv420 ? TJSAMP_420 : TJSAMP_444;
  JpegPicture jpeg{size_px, room_for(size_px, sampling)};
  std::array<const unsigned char*, 3> planes{};
  std::array<int, 3> strides{};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i] = picture.plane(i).bytes().data();
    strides[i] = static_cast<int>(picture.plane(i).stride_bytes());
  }
  unsigned char* out = jpeg.bytes.data();
  unsigned long size = jpeg.bytes.size();
  const int failed =
      tjCompressFromYUVPlanes(thread_compressor(), planes.data(), size_px.x, strides.data(),
                              size_px.y, sampling, &out, &size, quality, TJFLAG_NOREALLOC);
  if (failed != 0) throw refused();
  jpeg.bytes.resize(size);
  return jpeg;
}

}  // namespace cutaway
