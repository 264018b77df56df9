#include "core/log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>

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

std::shared_ptr<spdlog::logger> make_log() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintableMessage>('*').set_pattern("%H:%M:%S.%e %^%l%$ %*");
  auto logger = spdlog::stderr_color_mt("cutaway");
  logger->set_formatter(std::move(formatter));
  return logger;
}

}  // namespace

spdlog::logger& log() {
  static const auto logger = make_log();
  return *logger;
}

}  // namespace cutaway
