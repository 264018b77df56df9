#include "encode/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <string>

#include "core/check.h"
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

void check_sizes(const YcbcrPlanes& picture) {
  const int block_px = picture.halved_chroma ? 2 : 1;
  const auto columns = static_cast<std::size_t>((picture.width_px + block_px - 1) / block_px);
  const auto rows = static_cast<std::size_t>((picture.height_px + block_px - 1) / block_px);
  check_equal(picture.planes[0].size(), columns * rows * block_px * block_px,
              "size of the luma plane");
  check_equal(picture.planes[1].size(), columns * rows, "size of the Cb plane");
  check_equal(picture.planes[2].size(), columns * rows, "size of the Cr plane");
}

Error refused() {
  return Error(
      {.code = "internal", .message = std::string("JPEG: ") + tjGetErrorStr2(thread_compressor())});
}

std::vector<std::uint8_t> room_for(const YcbcrPlanes& picture, int sampling) {
  constexpr auto kNoSuchSize = static_cast<unsigned long>(-1);
  const unsigned long bytes = tjBufSize(picture.width_px, picture.height_px, sampling);
  if (bytes == kNoSuchSize) throw refused();
  return std::vector<std::uint8_t>(bytes);
}

}  // namespace

std::vector<std::uint8_t> encode_jpeg(const YcbcrPlanes& picture, int quality) {
  check_sizes(picture);
  const int sampling = picture.halved_chroma ? TJSAMP_420 : TJSAMP_444;
  std::vector<std::uint8_t> jpeg = room_for(picture, sampling);
  std::array<const unsigned char*, 3> planes{picture.planes[0].data(), picture.planes[1].data(),
                                             picture.planes[2].data()};
  unsigned char* out = jpeg.data();
  unsigned long size = jpeg.size();
  const int failed =
      tjCompressFromYUVPlanes(thread_compressor(), planes.data(), picture.width_px, nullptr,
                              picture.height_px, sampling, &out, &size, quality, TJFLAG_NOREALLOC);
  if (failed != 0) throw refused();
  jpeg.resize(size);
  return jpeg;
}

}  // namespace cutaway
