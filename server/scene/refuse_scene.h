// The error of a document whose fields are right each but make no sense together.
#pragma once

#include <string>

#include "core/error.h"
#include "scene/json_text.h"

namespace cutaway {

/// A shorter vector is no direction.
inline constexpr double kSmallestLength = 1e-9;
/// Sine of the angle below which two directions span no plane.
inline constexpr double kNearlyParallel = 1e-6;

/// `field` as a JSON pointer into the scene.
[[noreturn]] inline void refuse_scene(const std::string& field, const std::string& message,
                                      const std::string& expected, const Json& received) {
  throw Error({.code = ErrorCode::invalid_scene,
               .message = message,
               .field = field,
               .expected = expected,
               .received = json_text(received)});
}

}  // namespace cutaway
