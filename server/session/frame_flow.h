// From the newest scene to acknowledged frames: asks for frames when they are due and a credit is
// free, sends what comes back, and learns from how long both took.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "session/client_sink.h"
#include "session/credits.h"
#include "session/frame_message.h"
#include "session/frame_source.h"
#include "session/link_load.h"
#include "session/pacer.h"
#include "session/quality_control.h"
#include "session/weak_callbacks.h"

namespace cutaway {

struct SceneSnapshot {
  std::shared_ptr<const Scene> scene;
  std::uint32_t revision = 0;
  InputStamp stamp;
};

/// What the frames of one view go through.
struct ViewWiring {
  FrameSource& source;
  ClientSink& sink;
  LinkLoad& link;  ///< the session's; outlives the flow
  RenderView view;
  ViewKind kind = ViewKind::volume;
};

/// Of one view. Lives on the session's strand.
class FrameFlow {
 public:
  /// `failed` hears of each frame that could not be rendered.
  FrameFlow(const std::shared_ptr<Strand>& strand, const ViewWiring& wiring,
            const SessionSettings& settings, std::function<void(const Error&)> failed);
  ~FrameFlow();
  FrameFlow(const FrameFlow&) = delete;
  FrameFlow& operator=(const FrameFlow&) = delete;

  void show(SceneSnapshot snapshot);
  /// Makes no more frames before the next show, and frees what the renderer keeps for the view. No
  /// acknowledgement of what was sent is awaited any more; one that comes yet is fine.
  void hide();
  /// The newest scene has taken up another input that changed nothing in it.
  void restamp(InputStamp stamp) { newest_.stamp = stamp; }
  /// Returns the credits of this frame and those before it. Throws Error for a frame that is
  /// neither among those sent and not yet acknowledged nor the last acknowledged.
  void acknowledge(std::uint32_t frame);

 private:
  /// Asked for, and not yet come back from the source.
  struct Asked {
    std::uint64_t id;
    SceneSnapshot snapshot;
  };
  /// Sent, and not yet acknowledged.
  struct Sent {
    std::uint32_t number;
    FrameQuality quality;
    std::size_t bytes;
    std::size_t bytes_in_flight;
    TimePoint at;
  };

  void pump();
  bool is_early(FrameKind kind) const;
  bool renew(FrameKind kind);
  bool ask(FrameKind kind);
  bool has_finish(const Scene& scene) const;
  FrameQuality quality_of(FrameKind kind) const;
  FrameRequest request(FrameKind kind) const;
  void came_back(std::uint64_t id, FrameOutcome outcome);
  void send(const SceneSnapshot& shown, const Frame& frame);
  void written(std::uint32_t number, bool sent);
  void fail(const SceneSnapshot& shown, const Error& error);
  void check_awaited(std::uint32_t frame) const;
  void measure(const Sent& sent);

  std::shared_ptr<Strand> strand_;
  ViewWiring wiring_;
  std::function<void(const Error&)> failed_;
  Credits credits_;
  Pacer pacer_;
  QualityControl quality_;
  SceneSnapshot newest_;
  std::deque<Asked> asked_;
  std::deque<Sent> sent_;
  std::uint64_t last_id_ = 0;
  std::uint64_t last_sent_id_ = 0;
  std::uint32_t last_number_ = 0;
  std::optional<std::uint32_t> acknowledged_;
  std::optional<std::uint32_t> hidden_;  ///< the last frame before the view was hidden
  std::unique_ptr<Alarm> alarm_;
  WeakCallbacks callbacks_;
};

}  // namespace cutaway
