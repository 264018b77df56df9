// A picture that is too large to be drawn at once, from tiles drawn one after the other.
#pragma once

#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <vector>

#include "render/render_thread.h"

namespace cutaway {

/// Each tile is a frame of its own among those of other views, so that a still for print holds up
/// nobody. Lives for as long as its tiles are under way, and no longer than the renderer.
class TiledStill : public std::enable_shared_from_this<TiledStill> {
 public:
  /// Hears of the whole picture, as RGBA, or of what ended it.
  using Done = std::function<void(RenderOutcome)>;

  /// Whether a picture of this size is drawn in tiles.
  static bool is_due(glm::ivec2 size_px);

  /// `request` is of the whole picture. Tiles are put together on the pool, which outlives them.
  TiledStill(RenderRequest request, std::weak_ptr<RenderThread> renderer,
             boost::asio::thread_pool& pool, Done done);

  /// Asks for the first tile. Once.
  void start();

 private:
  struct Part {
    glm::ivec2 begin_px;  ///< of what the picture takes from the tile
    glm::ivec2 end_px;
    glm::ivec2 drawn_begin_px;  ///< of what is drawn, with a margin for the filters
    glm::ivec2 drawn_end_px;
  };

  Part part(int index) const;
  RenderRequest request_of(const Part& part) const;
  void draw_next();
  void drawn(const Part& part, const RenderOutcome& outcome);
  void take(const Part& part, const Pixels& tile);
  void finish(const RenderedFrame& last);

  RenderRequest request_;
  glm::ivec2 size_px_;
  int margin_px_;
  std::weak_ptr<RenderThread> renderer_;
  boost::asio::thread_pool& pool_;
  Done done_;
  int next_ = 0;
  std::uint64_t render_us_ = 0;
  std::vector<std::uint8_t> picture_;  ///< RGBA
};

}  // namespace cutaway
