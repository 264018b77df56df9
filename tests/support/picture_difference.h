// How far a picture is from what was expected, with the evidence kept when it is too far.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/reference_image.h"

namespace cutaway::test {

/// RGBA bytes, rows top first.
struct BytePicture {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> rgba;

  glm::ivec3 rgb(glm::ivec2 at) const;
};

BytePicture to_bytes(const reference::ColourImage& image);

/// In steps of 1/255 over all channels.
struct PictureDifference {
  double mean = 0.0;
  int maximum = 0;
  double share_above_2 = 0.0;  ///< of the pixels, those with a channel more than 2 steps off
};

PictureDifference compare(const BytePicture& actual, const BytePicture& expected);

/// Writes actual, expected and difference (times 8) as PNG under the folder of CUTAWAY_TEST_OUTPUT,
/// or test-output beside the test; returns the folder.
std::string save_evidence(const std::string& name, const BytePicture& actual,
                          const BytePicture& expected);

}  // namespace cutaway::test
