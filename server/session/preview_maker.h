// Small pictures of the client's scene in other styles, for a gallery.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>

#include "session/ends.h"
#include "session/frame_flow.h"

namespace cutaway {

/// One at a time, in a view of its own, beside the live frames and their credits; several may wait.
/// Lives on the session's strand.
class PreviewMaker {
 public:
  struct Hooks {
    /// The session's scene as it is now, in the style and of the size. Throws Error.
    std::function<SceneSnapshot(const PreviewMessage&)> scene;
    /// Hears of a preview that could not be made, with its request.
    std::function<void(std::uint32_t, const Error&)> failed;
  };

  PreviewMaker(std::shared_ptr<Strand> strand, FrameSource& source, ClientSink& sink,
               std::uint64_t view, Hooks hooks);
  ~PreviewMaker();
  PreviewMaker(const PreviewMaker&) = delete;
  PreviewMaker& operator=(const PreviewMaker&) = delete;

  /// Throws Error where too many wait.
  void want(const PreviewMessage& wish);

 private:
  void make_next();
  void begin(const PreviewMessage& wish);
  void came_back(std::uint32_t request, const SceneSnapshot& shown, FrameOutcome outcome);
  void ended();

  FrameSource& source_;
  ClientSink& sink_;
  std::uint64_t view_;
  Hooks hooks_;
  std::deque<PreviewMessage> waiting_;
  bool busy_ = false;
  Tether tether_;
};

}  // namespace cutaway
