// The client's wish for a lossless picture of a scene, of a size of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>

#include "session/client_sink.h"
#include "session/frame_flow.h"
#include "session/frame_source.h"

namespace cutaway {

/// One still at a time, in a view of its own, beside the live frames and their credits. One more
/// may wait, of the scene as it was when it was asked for. A client has the last bytes of a still
/// before the server knows that they are written, and may ask for the next at once: while a still
/// is written it has no place any more, and two may wait. Lives on the session's strand.
class StillSaver {
 public:
  /// `failed` hears of a still that could not be rendered, with its request.
  StillSaver(std::shared_ptr<Strand> strand, FrameSource& source, ClientSink& sink, RenderView view,
             std::function<void(std::uint32_t, const Error&)> failed);
  ~StillSaver();
  StillSaver(const StillSaver&) = delete;
  StillSaver& operator=(const StillSaver&) = delete;

  /// Throws Error while as many wait as may.
  void require_room() const;
  /// Of the snapshot's viewport. There is room for it.
  void save(std::uint32_t request, SceneSnapshot snapshot, const FrameQuality& quality);

 private:
  struct Waiting {
    std::uint32_t request;
    SceneSnapshot shown;
    FrameQuality quality;
  };

  /// Of the still that is not done: the next begins once it is written, so that one at most waits
  /// in the sink.
  enum class Stage { idle, making, writing };

  void make_next();
  void came_back(std::uint32_t request, const SceneSnapshot& shown, StillOutcome outcome);

  FrameSource& source_;
  ClientSink& sink_;
  RenderView view_;
  std::function<void(std::uint32_t, const Error&)> failed_;
  Stage stage_ = Stage::idle;
  std::deque<Waiting> waiting_;
  WeakCallbacks callbacks_;
};

}  // namespace cutaway
