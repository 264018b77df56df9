#include "app/tiled_still.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <limits>
#include <new>

#include "render/frame_pipeline.h"

namespace cutaway {

namespace {

/// Pictures up to this side are drawn at once; tiles have at most half of it.
constexpr int kLargestSide_px = 2048;
constexpr int kTileSide_px = kLargestSide_px / 2;
constexpr std::size_t kBytesAPixel = 4;

int tiles_along(int side_px) { return (side_px + kTileSide_px - 1) / kTileSide_px; }

Error given_up() {
  return Error({.code = "render-failed", .message = "the still was given up by the renderer"});
}

}  // namespace

bool TiledStill::is_due(glm::ivec2 size_px) {
  return std::max(size_px.x, size_px.y) > kLargestSide_px;
}

TiledStill::TiledStill(RenderRequest request, std::weak_ptr<RenderThread> renderer,
                       boost::asio::thread_pool& pool, Done done)
    : request_(std::move(request)),
      size_px_(request_.settings.picture_size_px),
      margin_px_(FramePipeline::tile_margin_px(*request_.scene)),
      renderer_(std::move(renderer)),
      pool_(pool),
      done_(std::move(done)) {}

void TiledStill::start() {
  try {
    picture_.resize(kBytesAPixel * static_cast<std::size_t>(size_px_.x) * size_px_.y);
  } catch (const std::bad_alloc&) {
    return done_(Error({.code = "too-large",
                        .message = "there is not enough memory for a still of this size",
                        .field = "/width_px"}));
  }
  draw_next();
}

TiledStill::Part TiledStill::part(int index) const {
  const int columns = tiles_along(size_px_.x);
  const glm::ivec2 begin = glm::ivec2(index % columns, index / columns) * kTileSide_px;
  const glm::ivec2 end = glm::min(begin + kTileSide_px, size_px_);
  return {begin, end, glm::max(begin - margin_px_, glm::ivec2(0)),
          glm::min(end + margin_px_, size_px_)};
}

RenderRequest TiledStill::request_of(const Part& part) const {
  RenderRequest request = request_;
  request.settings.picture_size_px = part.drawn_end_px - part.drawn_begin_px;
  request.settings.tile = PictureTile{part.drawn_begin_px, size_px_};
  return request;
}

// On the pool: were the render thread the last to hold the renderer, it would wait for itself.
void TiledStill::draw_next() {
  const auto renderer = renderer_.lock();
  if (!renderer) return done_(given_up());
  const Part next = part(next_++);
  renderer->submit({request_of(next), [self = shared_from_this(), next](RenderOutcome outcome) {
                      boost::asio::post(self->pool_, [self, next, outcome = std::move(outcome)] {
                        self->drawn(next, outcome);
                      });
                    }});
}

void TiledStill::drawn(const Part& part, const RenderOutcome& outcome) {
  const auto* frame = std::get_if<RenderedFrame>(&outcome);
  if (frame == nullptr) return done_(outcome);
  take(part, frame->pixels);
  render_us_ += frame->render_us;
  if (next_ < tiles_along(size_px_.x) * tiles_along(size_px_.y)) return draw_next();
  finish(*frame);
}

void TiledStill::take(const Part& part, const Pixels& tile) {
  const auto& drawn = tile.planes.at(0);
  const glm::ivec2 inset = part.begin_px - part.drawn_begin_px;
  const std::size_t row_bytes = kBytesAPixel * (part.end_px.x - part.begin_px.x);
  for (int y = part.begin_px.y; y < part.end_px.y; ++y) {
    const std::size_t row = y - part.drawn_begin_px.y;
    const auto from = drawn.begin() + kBytesAPixel * (row * tile.size_px.x + inset.x);
    const auto to =
        picture_.begin() + kBytesAPixel * (std::size_t(y) * size_px_.x + part.begin_px.x);
    std::copy_n(from, row_bytes, to);
  }
}

void TiledStill::finish(const RenderedFrame& last) {
  constexpr std::uint64_t kLongest = std::numeric_limits<std::uint32_t>::max();
  RenderedFrame whole{.pixels = {PixelLayout::rgba, size_px_, {}},
                      .cast_rays = last.cast_rays,
                      .label = last.label};
  whole.pixels.planes.push_back(std::move(picture_));
  whole.render_us = static_cast<std::uint32_t>(std::min(render_us_, kLongest));
  done_(std::move(whole));
}

}  // namespace cutaway
