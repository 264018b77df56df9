// Small pictures of the client's scene in other styles, for a gallery, and of other volumes, for a
// listing.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>

#include "session/client_sink.h"
#include "session/frame_flow.h"
#include "session/frame_source.h"
#include "session/preview_cache.h"
#include "session/volume_library.h"

namespace cutaway {

/// One at a time, in a view of its own, beside the live frames and their credits; several may wait.
/// Another volume is open only while its picture is made. Lives on the session's strand.
class PreviewMaker {
 public:
  struct Wiring {
    std::shared_ptr<Strand> strand;
    FrameSource& source;
    VolumeLibrary& volumes;
    ClientSink& sink;
    PreviewCache& cache;
    RenderView view;
  };
  struct Hooks {
    /// What the preview shows: of the other volume where there is one, else of the session's scene
    /// as it is now. Throws Error.
    std::function<SceneSnapshot(const PreviewMessage&, const OpenVolume* other)> scene;
    /// Hears of a preview that could not be made, with its request.
    std::function<void(std::uint32_t, const Error&)> failed;
  };

  PreviewMaker(Wiring wiring, Hooks hooks);
  ~PreviewMaker();
  PreviewMaker(const PreviewMaker&) = delete;
  PreviewMaker& operator=(const PreviewMaker&) = delete;

  /// Throws Error where too many wait.
  void want(const PreviewMessage& wish);

 private:
  void make_next();
  void begin(const PreviewMessage& wish);
  void open(const PreviewMessage& wish);
  void opened(const PreviewMessage& wish, OpenOutcome outcome);
  void render(const PreviewMessage& wish);
  void came_back(const PreviewMessage& wish, const SceneSnapshot& shown, FrameOutcome outcome);
  void send(const PreviewMessage& wish, const InputStamp& stamp, const Frame& frame);
  void fail(const PreviewMessage& wish, const Error& error);
  void ended();

  Wiring wiring_;
  Hooks hooks_;
  std::deque<PreviewMessage> waiting_;
  bool busy_ = false;
  std::unique_ptr<OpenTicket> ticket_;
  std::shared_ptr<const OpenVolume> other_;  ///< the preview's that is being made
  WeakCallbacks callbacks_;
};

}  // namespace cutaway
