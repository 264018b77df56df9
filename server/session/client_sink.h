// Where a session's messages and frames go. A session knows no socket; tests put a sink of their
// own here.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace cutaway {
/// Where a session's messages go: the WebSocket, or a test. Called on the session's strand only.
class ClientSink {
 public:
  virtual ~ClientSink() = default;
  virtual void send_text(std::string message) = 0;
  /// Takes the place of the last one sent this way where that one still waits.
  virtual void send_latest_text(std::string message) = 0;
  /// At most one frame of each view waits behind the one being written; `done(false)` when it was
  /// replaced or could not be sent.
  virtual void send_frame(ViewKind view, std::vector<std::uint8_t> message,
                          std::function<void(bool)> done) = 0;
  /// A saved still or a preview is never replaced; the session has at most one of each under way.
  virtual void send_still(std::vector<std::uint8_t> message, std::function<void(bool)> done) = 0;
};

}  // namespace cutaway
