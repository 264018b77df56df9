#include "session/frame_message.h"

#include "scene/frame_header.h"

namespace cutaway {

namespace {

std::vector<std::uint8_t> message(PictureType type, std::uint32_t number, const InputStamp& stamp,
                                  Viewport viewport, const Frame& frame) {
  const bool saved = type == PictureType::saved_still;
  const auto header =
      encode_frame_header({.type = type,
                           .still_quality = frame.quality.still,
                           .lossless = saved,
                           .view = static_cast<std::uint16_t>(viewport.kind),
                           .frame = number,
                           .revision = frame.revision,
                           .input = stamp.input,
                           .clock_ms = stamp.clock_ms,
                           .render_us = frame.render_us,
                           .encode_us = frame.encode_us,
                           .picture_width_px = static_cast<std::uint16_t>(frame.width_px),
                           .picture_height_px = static_cast<std::uint16_t>(frame.height_px),
                           .viewport_width_px = static_cast<std::uint16_t>(viewport.width_px),
                           .viewport_height_px = static_cast<std::uint16_t>(viewport.height_px),
                           .picture_bytes = static_cast<std::uint32_t>(frame.picture.size())});
  std::vector<std::uint8_t> bytes;
  bytes.reserve(header.size() + frame.picture.size());
  bytes.insert(bytes.end(), header.begin(), header.end());
  bytes.insert(bytes.end(), frame.picture.begin(), frame.picture.end());
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> live_frame_message(std::uint32_t number, const InputStamp& stamp,
                                             Viewport viewport, const Frame& frame) {
  return message(PictureType::live_frame, number, stamp, viewport, frame);
}

std::vector<std::uint8_t> preview_message(std::uint32_t request, const InputStamp& stamp,
                                          Viewport viewport, const Frame& frame) {
  return message(PictureType::preview, request, stamp, viewport, frame);
}

std::vector<std::uint8_t> saved_still_message(std::uint32_t request, const InputStamp& stamp,
                                              Viewport viewport, const Frame& frame) {
  return message(PictureType::saved_still, request, stamp, viewport, frame);
}

}  // namespace cutaway
