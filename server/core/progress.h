// How long work says how far it is, and hears that nobody wants it any more.
#pragma once

#include <array>
#include <functional>
#include <stop_token>

#include "core/error.h"

namespace cutaway {

/// The stages of opening a volume, in order.
enum class LoadStage { read, decode, min_max, upload };
/// Their names on the wire and between processes.
inline constexpr std::array<const char*, 4> kLoadStageNames = {"read", "decode", "min_max",
                                                               "upload"};

inline const char* name_of(LoadStage stage) {
  return kLoadStageNames.at(static_cast<std::size_t>(stage));
}

/// Called with a stage and its fraction 0..1, from the thread that works; must return quickly.
using ProgressSink = std::function<void(LoadStage, double)>;

/// Throws Cancelled when the token asks to stop.
inline void throw_if_cancelled(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

}  // namespace cutaway
