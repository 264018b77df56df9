// Binary messages: a header and a picture (scene/frame_header.h has the layout).
#pragma once

#include <cstdint>
#include <vector>

#include "scene/client_message.h"
#include "session/frame_source.h"

namespace cutaway {

/// `number` counts the frames of the viewport's view.
std::vector<std::uint8_t> live_frame_message(std::uint32_t number, const InputStamp& stamp,
                                             Viewport viewport, const Frame& frame);

std::vector<std::uint8_t> preview_message(std::uint32_t request, const InputStamp& stamp,
                                          Viewport viewport, const Frame& frame);

std::vector<std::uint8_t> saved_still_message(std::uint32_t request, const InputStamp& stamp,
                                              Viewport viewport, const SavedStill& still);

}  // namespace cutaway
