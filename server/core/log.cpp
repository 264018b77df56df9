#include "core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

namespace cutaway {

spdlog::logger& log() {
  static const auto logger = spdlog::stderr_color_mt("cutaway");
  return *logger;
}

}  // namespace cutaway
