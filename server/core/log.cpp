#include "core/log.h"

#include <poll.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <unistd.h>

#include <atomic>
#include <utility>

#include "core/printable.h"

namespace cutaway {

namespace {

/// The message itself: much of what is logged was sent by a client or stands in a file.
class PrintableMessage final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& line) override {
    const std::string text = printable({message.payload.data(), message.payload.size()});
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<PrintableMessage>();
  }
};

/// Who reads the log may have stopped, and a pipe that is full would hold up whoever writes a line:
/// such lines are left out, and counted in the first that goes through again.
class UnblockedSink final : public spdlog::sinks::stderr_color_sink_mt {
  using Sink = spdlog::sinks::stderr_color_sink_mt;

 public:
  void log(const spdlog::details::log_msg& message) override {
    if (!has_room()) {
      ++lost_;
      return;
    }
    if (const int lost = lost_.exchange(0); lost > 0) say_lost(message, lost);
    Sink::log(message);
  }

 private:
  static bool has_room() {
    pollfd error{STDERR_FILENO, POLLOUT, 0};
    return poll(&error, 1, 0) > 0;
  }

  void say_lost(const spdlog::details::log_msg& next, int lost) {
    const std::string text = std::to_string(lost) + " lines were left out, as nobody read them";
    Sink::log({next.time, {}, next.logger_name, spdlog::level::warn, text});
  }

  std::atomic<int> lost_{0};
};

std::shared_ptr<spdlog::logger> make_log() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintableMessage>('*').set_pattern("%H:%M:%S.%e %^%l%$ %*");
  auto logger = std::make_shared<spdlog::logger>("cutaway", std::make_shared<UnblockedSink>());
  logger->set_formatter(std::move(formatter));
  return logger;
}

}  // namespace

spdlog::logger& log() {
  static const auto logger = make_log();
  return *logger;
}

}  // namespace cutaway
