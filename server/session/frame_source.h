// Where a session's frames come from. A session knows no GL; tests put a source of their own here.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "core/error.h"
#include "core/picture.h"
#include "scene/scene.h"

namespace cutaway {

enum class ChromaSampling { yuv420, yuv444 };

/// How thoroughly light that is kept away is looked for, where the scene draws it.
enum class LightDetail { quick, full };

/// What a frame may cost. The viewport stays as it is in the scene: a smaller picture is scaled up
/// by the client.
struct FrameQuality {
  double resolution_scale = 1.0;  ///< 0.1..1 of the viewport, each way
  int supersampling = 1;          ///< 1 or 2 rays a pixel each way, averaged
  LightDetail light = LightDetail::quick;
  double step_voxels = 1.0;  ///< ray step in units of the smallest spacing
  int jpeg_quality = 80;     ///< 1..100
  ChromaSampling chroma = ChromaSampling::yuv420;
  bool still = false;  ///< the refined picture of a scene at rest
  bool operator==(const FrameQuality&) const = default;
};

/// The picture's full size is the scene's viewport. A saved still is a request of its own view with
/// a scene of its own viewport, so that the session's live view neither replaces it nor loses what
/// is kept for it.
struct FrameRequest {
  std::uint64_t view = 0;   ///< names the state kept between frames
  std::uint64_t share = 0;  ///< the views of a session have one share of the renderer together
  std::string session;      ///< its name, for the log
  std::uint32_t revision = 0;
  std::shared_ptr<const Scene> scene;
  FrameQuality quality;  ///< of a saved still its jpeg_quality and chroma mean nothing
};

/// What comes of a request, with its picture as a file of one format.
template <typename PictureFile>
struct Made {
  PictureFile picture;
  std::uint32_t revision = 0;
  FrameQuality quality;
  std::uint32_t render_us = 0;
  std::uint32_t encode_us = 0;
  bool cast_rays = true;  ///< else its time says nothing of what another frame will take
};

struct FrameReplaced {};  ///< a newer request of the same view took its place before it began

using Frame = Made<JpegPicture>;
using SavedStill = Made<PngPicture>;
using FrameOutcome = std::variant<Frame, FrameReplaced, Error>;
using StillOutcome = std::variant<SavedStill, FrameReplaced, Error>;

/// The renderer's names for a view and for its session, and the log's for the session.
struct RenderView {
  std::uint64_t view = 0;
  std::uint64_t share = 0;
  std::string session;
};

/// For a picture that was asked for once, and was replaced or released.
inline Error picture_given_up() {
  return Error(
      {.code = ErrorCode::render_failed, .message = "the picture was given up by the renderer"});
}

/// What renders, for people: in `capabilities` and the log.
struct RendererDescription {
  std::string name;
  bool software = false;
};

/// Thread-safe. `done` is called exactly once for every submit, from any thread, never from inside
/// it.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// A request of the view that has not begun ends as FrameReplaced: one place for each view.
  virtual void submit(FrameRequest request, std::function<void(FrameOutcome)> done) = 0;
  /// The same for a saved still. Large ones take turns by `share`, and keep no frame waiting.
  virtual void submit_still(FrameRequest request, std::function<void(StillOutcome)> done) = 0;
  /// Puts `request` in the place of its view's request that has not begun, whose `done` stays: so
  /// the newest input is shown without another frame in flight. False, and nothing done, where none
  /// waits.
  virtual bool renew(const FrameRequest& request) = 0;
  /// Frees what is kept for the view. Requests of it that have not begun end as FrameReplaced.
  /// Unknown views are ignored.
  virtual void release(std::uint64_t view) = 0;
  virtual RendererDescription describe() const = 0;
  /// Why no frame can be rendered at present; empty while all is well.
  virtual std::string trouble() const = 0;
};

}  // namespace cutaway
