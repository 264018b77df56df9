// The listener and its threads: HTTP and WebSocket on one port.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "net/http_answers.h"
#include "net/settings.h"
#include "net/web_socket.h"

namespace cutaway {

class Server {
 public:
  struct Hooks {
    HttpAnswers::Sources sources;
    SessionFactory make_session;  ///< called on the new session's strand
  };

  /// Listens from here on. Throws Error where the address cannot be had.
  Server(const NetSettings& settings, Hooks hooks);
  /// After run has returned.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// "http://127.0.0.1:8080/", with the port that was got.
  std::string url() const;

  /// Serves on the calling thread and the others of the settings until stop is called or SIGINT,
  /// SIGTERM or SIGQUIT comes, a second of which ends the process at once; when it returns, every
  /// session has ended. `on_ready` is called when all of that stands. Throws Error where so many
  /// threads cannot be had.
  void run(const std::function<void()>& on_ready = {});
  /// Closes every session with "going away", and what has not ended by the stop timeout at once.
  /// Any thread.
  void stop();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cutaway
