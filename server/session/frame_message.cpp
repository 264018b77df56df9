#include "session/frame_message.h"

#include <type_traits>

#include "scene/frame_header.h"

namespace cutaway {

namespace {

FrameHeader header_of(PictureType type, std::uint32_t number, const InputStamp& stamp,
                      Viewport viewport) {
  return {.type = type,
          .view = static_cast<std::uint16_t>(viewport.kind),
          .frame = number,
          .input = stamp.input,
          .clock_ms = stamp.clock_ms,
          .viewport_width_px = static_cast<std::uint16_t>(viewport.width_px),
          .viewport_height_px = static_cast<std::uint16_t>(viewport.height_px)};
}

template <typename PictureFile>
std::vector<std::uint8_t> message(FrameHeader header, const Made<PictureFile>& made) {
  const PictureFile& picture = made.picture;
  header.still_quality = made.quality.still;
  header.lossless = std::is_same_v<PictureFile, PngPicture>;
  header.revision = made.revision;
  header.render_us = made.render_us;
  header.encode_us = made.encode_us;
  header.picture_width_px = static_cast<std::uint16_t>(picture.size_px.x);
  header.picture_height_px = static_cast<std::uint16_t>(picture.size_px.y);
  header.picture_bytes = static_cast<std::uint32_t>(picture.bytes.size());
  const auto encoded = encode_frame_header(header);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(encoded.size() + picture.bytes.size());
  bytes.insert(bytes.end(), encoded.begin(), encoded.end());
  bytes.insert(bytes.end(), picture.bytes.begin(), picture.bytes.end());
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> live_frame_message(std::uint32_t number, const InputStamp& stamp,
                                             Viewport viewport, const Frame& frame) {
  return message(header_of(PictureType::live_frame, number, stamp, viewport), frame);
}

std::vector<std::uint8_t> preview_message(std::uint32_t request, const InputStamp& stamp,
                                          Viewport viewport, const Frame& frame) {
  return message(header_of(PictureType::preview, request, stamp, viewport), frame);
}

std::vector<std::uint8_t> saved_still_message(std::uint32_t request, const InputStamp& stamp,
                                              Viewport viewport, const SavedStill& still) {
  return message(header_of(PictureType::saved_still, request, stamp, viewport), still);
}

}  // namespace cutaway
