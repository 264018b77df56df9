// One client's state, from its first message to its last: what it shows, what it waits for, what it
// may still ask.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene/client_message.h"
#include "scene/server_message.h"
#include "session/client_sink.h"
#include "session/frame_flow.h"
#include "session/frame_source.h"
#include "session/preview_maker.h"
#include "session/scene_state.h"
#include "session/settings.h"
#include "session/still_saver.h"
#include "session/token_bucket.h"
#include "session/unseen_watch.h"
#include "session/volume_library.h"
#include "session/volume_opening.h"

namespace cutaway {

/// What a session works with. The references outlive it.
struct SessionWiring {
  std::string name;  ///< for the log
  std::shared_ptr<Strand> strand;
  FrameSource& frames;
  VolumeLibrary& volumes;
  ClientSink& client;
  std::array<std::uint64_t, kViews> live_views{};   ///< of no other session
  std::uint64_t still_view = 0;                     ///< likewise, nor one of these
  std::uint64_t preview_view = 0;                   ///< likewise
  std::uint64_t volume_preview_view = 0;            ///< likewise
  PreviewCache& previews;                           ///< shared by all sessions
  std::shared_ptr<const std::string> capabilities;  ///< the message, ready to send
};

/// Created, used and destroyed on its strand. Nothing that a client sends makes a member function
/// throw: what is wrong is answered with an `error` message, and the last good state stands.
class Session {
 public:
  enum class Reception { taken, too_fast };

  Session(SessionWiring wiring, const SessionSettings& settings);

  /// Says what the server can do and what there is to see.
  void start();
  Reception receive_text(std::string_view text);
  Reception receive_binary();
  /// A message of `bytes`, which is more than the `most` that are read.
  Reception receive_too_large(std::size_t bytes, std::size_t most);
  /// Whether the client says that its page is seen; false for one that never said.
  bool page_visible() const { return page_visible_; }

 private:
  /// A volume that is on its way, with the scene that is to be shown with it.
  struct Pending {
    std::string volume;
    Json document;
    InputStamp stamp;
  };

  Reception refuse_too_fast();
  void pay_for_lens_searches();
  void handle(const SceneMessage& message);
  void handle(const ViewportMessage& message);
  void handle(const DragLensMessage& message);
  void handle(const PickMessage& message);
  void handle(const CancelLoadMessage& message);
  void handle(const AckMessage& message);
  void handle(const SaveStillMessage& message);
  void handle(const PreviewMessage& message);
  void handle(const CloseViewMessage& message);
  void handle(const PresenceMessage& message);

  void open_volume(const std::string& id, Json document, InputStamp stamp);
  void change_shown(const SceneMessage& message);
  void opened(OpenOutcome outcome);
  void opening_failed(const Error& error, const Pending& pending);
  void show_opened(std::shared_ptr<const OpenVolume> volume, const Pending& pending);
  void stop_opening();
  void prepare_shown();
  void took_effect(SceneState::Change change, InputStamp stamp);

  RenderView render_view(std::uint64_t view) const;
  PreviewMaker::Wiring preview_wiring(std::uint64_t view) const;
  PreviewMaker::Hooks preview_hooks();
  FrameFlow& flow(ViewKind view) { return *flows_[static_cast<std::size_t>(view)]; }
  const Scene& shown_scene(ViewKind view = ViewKind::volume) const;
  void check_pixels(int width_px, int height_px) const;
  void tell_scene();
  void tell_scene_soon();
  void tell_volumes();
  void tell(const Json& message);
  void refuse(const Error& error, const MessageEcho& echo);
  SceneSnapshot snapshot(ViewKind view) const;
  SceneSnapshot still_of(const SaveStillMessage& wish);
  SceneSnapshot preview_of(const PreviewMessage& wish, const OpenVolume* other);

  SessionWiring wiring_;
  SessionSettings settings_;
  TokenBucket message_rate_;
  TokenBucket refusal_rate_;
  SceneState state_;
  InputStamp stamp_;  ///< of the newest message that changed the scene, or will
  LinkLoad link_;
  std::array<std::unique_ptr<FrameFlow>, kViews> flows_;
  StillSaver stills_;
  PreviewMaker previews_;          ///< of the session's scene
  PreviewMaker volume_previews_;   ///< of other volumes, which take long to open
  LensMemory lenses_of_pictures_;  ///< of scenes that are not taken up
  UnseenWatch unseen_;
  VolumeOpening opening_;
  std::optional<Pending> pending_;
  std::optional<TimePoint> scene_told_at_;
  std::shared_ptr<const OpenVolume> told_volume_;
  std::unique_ptr<Alarm> scene_alarm_;
  std::optional<Scene> prepared_for_;  ///< the scene that asked for it last
  std::unique_ptr<OpenTicket> preparing_;
  bool page_visible_ = false;
  WeakCallbacks callbacks_;
  std::unique_ptr<OpenTicket> listing_watch_;
};

}  // namespace cutaway
