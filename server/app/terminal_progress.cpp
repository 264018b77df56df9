#include "app/terminal_progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace cutaway {

namespace {

const char* words(LoadStage stage) {
  switch (stage) {
    case LoadStage::read:
      return "Reading";
    case LoadStage::decode:
      return "Decoding";
    case LoadStage::min_max:
      return "Measuring";
    case LoadStage::upload:
      return "Uploading";
  }
  return "";
}

}  // namespace

ProgressSink terminal_progress() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [last = -1](LoadStage stage, double fraction) mutable {
    const int percent = static_cast<int>(std::lround(100.0 * fraction));
    const int shown = static_cast<int>(stage) * 1000 + percent;
    if (shown == last) return;
    last = shown;
    const bool is_end = stage == LoadStage::min_max && percent == 100;
    std::fprintf(stderr, "\r%-10s %3d %%%s", words(stage), percent, is_end ? "\n" : "");
  };
}

}  // namespace cutaway
