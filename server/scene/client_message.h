// What a client sends, as values; protocol/schema/client-message.schema.json says what each field
// may hold.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <variant>

#include "core/error.h"
#include "scene/json.h"
#include "scene/scene.h"

namespace cutaway {

/// Which input of the client's this is, and when it happened by the client's own clock.
struct InputStamp {
  std::uint32_t input = 0;
  double clock_ms = 0.0;
};

struct SceneMessage {
  InputStamp stamp;
  Json scene;  ///< a merge patch, not checked yet: patch_scene_document does
  bool replace = false;
};

/// Of one session: the volume in 3-D and three slices. A view's number in messages and frames is
/// its ViewKind's.
inline constexpr int kViews = 4;

struct ViewportMessage {
  ViewKind view = ViewKind::volume;
  InputStamp stamp;
  int width_px = 0;
  int height_px = 0;
};

struct DragLensMessage {
  InputStamp stamp;
  glm::dvec2 position_px{0.0};
};

struct PickMessage {
  ViewKind view = ViewKind::volume;
  std::uint32_t request = 0;
  glm::dvec2 position_px{0.0};
};

struct CancelLoadMessage {};

struct AckMessage {
  ViewKind view = ViewKind::volume;
  std::uint32_t frame = 0;
};

struct SaveStillMessage {
  ViewKind view = ViewKind::volume;
  std::uint32_t request = 0;
  int width_px = 0;
  int height_px = 0;
  Json scene = Json::object();  ///< a merge patch for this picture alone
};

struct PreviewMessage {
  std::uint32_t request = 0;
  std::optional<std::string> style;   ///< else the session's own
  std::optional<std::string> volume;  ///< else the session's scene
  Json scene = Json::object();        ///< a merge patch for this picture alone
  int width_px = 0;
  int height_px = 0;
};

struct CloseViewMessage {
  ViewKind view = ViewKind::axial;
};

struct PresenceMessage {
  bool visible = false;  ///< whether the page can be seen
};

using ClientMessage =
    std::variant<SceneMessage, ViewportMessage, DragLensMessage, PickMessage, CancelLoadMessage,
                 AckMessage, SaveStillMessage, PreviewMessage, CloseViewMessage, PresenceMessage>;

/// The largest side (px) that the schema allows; a server may be set to take less.
inline constexpr int kLargestSide_px = 8192;

struct SideLimits {
  int viewport_px = kLargestSide_px;
  int still_px = kLargestSide_px;
};

/// Throws Error: malformed-json, not-finite, unknown-message, unknown-field, missing-field,
/// wrong-type, out-of-range. A side of a viewport or a saved still over `limits` is
/// refused with that limit, not with the schema's.
ClientMessage parse_client_message(std::string_view text, const SideLimits& limits = {});

/// The error for a binary message from a client.
Error binary_message_error();

/// What an answer repeats of the message it answers.
struct MessageEcho {
  std::optional<std::uint32_t> input = {};
  std::optional<std::uint32_t> request = {};
};

/// For the answer to a message that was refused: whatever of it can still be read. Never throws for
/// the content.
MessageEcho echo_of(std::string_view text);

/// For the answer to a message that was understood and then refused.
MessageEcho echo_of(const ClientMessage& message);

}  // namespace cutaway
