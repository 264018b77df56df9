#include "support/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/check.h"
#include "encode/png.h"

namespace cutaway::test {

namespace {

void save(const std::filesystem::path& path, const BytePicture& picture) {
  const auto png =
      encode_png(
          {PixelLayout::rgba, picture.size_px, {PixelPlane(picture.size_px, 4, picture.rgba)}})
          .bytes;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
}

std::filesystem::path output_folder() {
  const char* chosen = std::getenv("CUTAWAY_TEST_OUTPUT");
  std::filesystem::path folder = chosen != nullptr ? chosen : "test-output";
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

glm::ivec3 BytePicture::rgb(glm::ivec2 at) const {
  const auto first = (static_cast<std::size_t>(at.y) * size_px.x + at.x) * 4;
  return {rgba[first], rgba[first + 1], rgba[first + 2]};
}

BytePicture to_bytes(const reference::ColourImage& image) {
  BytePicture picture{image.size_px, {}};
  for (const glm::dvec3& colour : image.pixels) {
    for (int c = 0; c < 3; ++c) {
      picture.rgba.push_back(
          static_cast<std::uint8_t>(std::lround(std::clamp(colour[c], 0.0, 1.0) * 255.0)));
    }
    picture.rgba.push_back(255);
  }
  return picture;
}

PictureDifference compare(const BytePicture& actual, const BytePicture& expected) {
  check_equal(actual.rgba.size(), expected.rgba.size(), "pictures have one size");
  PictureDifference result;
  std::size_t above = 0;
  for (std::size_t i = 0; i < actual.rgba.size(); i += 4) {
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int apart = std::abs(int{actual.rgba[i + c]} - int{expected.rgba[i + c]});
      result.mean += apart;
      worst = std::max(worst, apart);
    }
    result.maximum = std::max(result.maximum, worst);
    if (worst > 2) ++above;
  }
  const auto pixels = static_cast<double>(actual.rgba.size()) / 4.0;
  result.mean /= pixels * 3.0;
  result.share_above_2 = static_cast<double>(above) / pixels;
  return result;
}

std::string save_evidence(const std::string& name, const BytePicture& actual,
                          const BytePicture& expected) {
  BytePicture difference = actual;
  for (std::size_t i = 0; i < actual.rgba.size(); ++i) {
    const int apart = std::abs(int{actual.rgba[i]} - int{expected.rgba[i]});
    difference.rgba[i] = static_cast<std::uint8_t>(std::min(255, apart * 8));
  }
  const auto folder = output_folder();
  save(folder / (name + "-actual.png"), actual);
  save(folder / (name + "-expected.png"), expected);
  save(folder / (name + "-difference.png"), difference);
  return folder.string();
}

}  // namespace cutaway::test
