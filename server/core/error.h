// What goes wrong with data and requests, in words for the person who sent them.
#pragma once

#include <stdexcept>
#include <string>

#include "core/error_code.h"

namespace cutaway {

/// Bad data or a bad request; our own bugs are `check` failures instead (check.h).
/// `field` is a JSON pointer ("/lens/radius_mm") or a file's path; `expected` states the limit and
/// its unit; `received` what came. Empty strings mean "does not apply". Immutable, so it may cross
/// threads.
class Error : public std::runtime_error {
 public:
  struct Detail {
    ErrorCode code = ErrorCode::internal;
    std::string message;
    std::string field = {};
    std::string expected = {};
    std::string received = {};
  };

  explicit Error(Detail detail);
  const Detail& detail() const noexcept { return detail_; }

 private:
  Detail detail_;
};

/// Thrown by long work that was asked to stop; nobody's fault, so not an Error.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace cutaway
