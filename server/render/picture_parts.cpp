#include "render/picture_parts.h"

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "render/stage_keys.h"

namespace cutaway {

namespace {

/// Of a part, without its margin. Even, since chroma of 4:2:0 is shared by pairs of pixels.
constexpr int kLargestSide_px = 1024;
constexpr int kSmallestSide_px = 64;

int rounded_up(int number, int multiple) { return (number + multiple - 1) / multiple * multiple; }

bool fits(const Scene& scene, RenderSettings settings, glm::ivec2 size_px,
          const PartLimits& limits) {
  settings.picture_size_px = size_px;
  const BufferNeeds needs = needs_of(scene, settings);
  return bytes_for(needs) <= limits.bytes && longest_side_px(needs) <= limits.side_px;
}

int part_side_px(const Scene& scene, const RenderSettings& whole, int margin_px,
                 const PartLimits& limits) {
  int side_px = kLargestSide_px;
  while (side_px > kSmallestSide_px &&
         !fits(scene, whole, glm::min(glm::ivec2(side_px + 2 * margin_px), whole.picture_size_px),
               limits))
    side_px /= 2;
  return side_px;
}

}  // namespace

PictureParts::PictureParts(const Scene& scene, const RenderSettings& whole,
                           const PartLimits& limits)
    : whole_(whole) {
  const glm::ivec2 size_px = whole.picture_size_px;
  const PixelRect all{{0, 0}, size_px};
  if (whole.tile || fits(scene, whole, size_px, limits)) {
    parts_.push_back({all, all});
    return;
  }
  const int margin_px = rounded_up(tile_margin_px(scene), 2);
  const int side_px = part_side_px(scene, whole, margin_px, limits);
  for (int y = 0; y < size_px.y; y += side_px) {
    for (int x = 0; x < size_px.x; x += side_px) {
      const PixelRect taken{{x, y}, glm::min(glm::ivec2(x, y) + side_px, size_px)};
      parts_.push_back({taken,
                        {glm::max(taken.begin - margin_px, glm::ivec2(0)),
                         glm::min(taken.end + margin_px, size_px)}});
    }
  }
}

RenderSettings PictureParts::settings(std::size_t index) const {
  if (parts_.size() == 1) return whole_;
  const PixelRect& drawn = parts_.at(index).drawn;
  RenderSettings settings = whole_;
  settings.picture_size_px = drawn.size_px();
  settings.tile = PictureTile{drawn.begin, whole_.picture_size_px};
  return settings;
}

void PictureParts::take(std::size_t index, Picture drawn) {
  const Part& part = parts_.at(index);
  check(drawn.size_px() == part.drawn.size_px(), "a part comes as it was asked for");
  if (parts_.size() == 1) {
    picture_ = std::move(drawn);
  } else {
    if (taken_ == 0) picture_ = Picture(whole_.layout, whole_.picture_size_px);
    const glm::ivec2 inset = part.taken.begin - part.drawn.begin;
    picture_.copy(drawn, {inset, inset + part.taken.size_px()}, part.taken.begin);
  }
  ++taken_;
}

Picture PictureParts::whole() {
  check(is_whole(), "a picture is handed over once all of its parts are taken");
  return std::move(picture_);
}

}  // namespace cutaway
