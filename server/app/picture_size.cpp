#include "app/picture_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "scene/client_message.h"

namespace cutaway {

namespace {

Error no_such_size(const std::string& received) {
  return Error({.code = ErrorCode::out_of_range,
                .message = "there is no picture of this size",
                .expected = fmt::format("1x1 to {0}x{0} px", kLargestSide_px),
                .received = received});
}

}  // namespace

Viewport parse_picture_size(const std::string& text) {
  Viewport size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width_px);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') throw no_such_size(text);
  const auto height = std::from_chars(width.ptr + 1, end, size.height_px);
  if (height.ec != std::errc{} || height.ptr != end) throw no_such_size(text);
  check_picture_size(size);
  return size;
}

void check_picture_size(Viewport size) {
  const auto [shorter, longer] = std::minmax(size.width_px, size.height_px);
  if (shorter >= 1 && longer <= kLargestSide_px) return;
  throw no_such_size(fmt::format("{}x{}", size.width_px, size.height_px));
}

}  // namespace cutaway
