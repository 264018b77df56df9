// Every limit and target of one session; the configuration fills it (app/config.h).
#pragma once

#include <cstdint>

#include "session/strand.h"
#include "session/token_bucket.h"

namespace cutaway {

struct SessionSettings {
  int frames_in_flight = 2;
  Milliseconds frame_budget{33.0};  ///< what an interactive frame may take to render and to travel
  /// Of a session's first frame, while nothing is known of what one costs; 0.25 to 1.
  double first_resolution_scale = 1.0;
  Milliseconds rest{200.0};  ///< without input, before the still frame
  int still_jpeg_quality = 92;
  int still_supersampling = 2;          ///< rays a pixel, each way, where still_rays allows it
  std::int64_t still_rays = 8'400'000;  ///< of a still frame: a larger one gets fewer a pixel
  Milliseconds still_budget{500.0};     ///< for a still's rendering: where more rays a pixel are
                                        ///< expected to take longer, it gets fewer
  int still_side_px = 8192;             ///< of a saved still
  int viewport_side_px = 4096;
  std::int64_t viewport_pixels = std::int64_t{4096} * 2304;
  MessageRate messages;
  /// Messages that looking for a lens' place counts for: the others wait for as long as it takes,
  /// some 50 ms for a large CT.
  double lens_search_messages = 200.0;
  bool operator==(const SessionSettings&) const = default;
};

}  // namespace cutaway
