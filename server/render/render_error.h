// A picture that could not be made, in words for the one who asked.
#pragma once

#include <cstdint>
#include <exception>
#include <string_view>

#include "core/error.h"

namespace cutaway {

/// What `owner`, who asked for a picture of `view`, is told of an exception; the log has the rest.
/// Any thread.
Error render_error(const std::exception& failure, std::string_view owner, std::uint64_t view);

}  // namespace cutaway
