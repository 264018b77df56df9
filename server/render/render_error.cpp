#include "render/render_error.h"

#include <new>

#include "core/log.h"

namespace cutaway {

Error render_error(const std::exception& failure, std::string_view owner, std::uint64_t view) {
  if (const auto* error = dynamic_cast<const Error*>(&failure)) return *error;
  if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr) {
    return Error({.code = ErrorCode::too_large,
                  .message = "there is not enough memory for a picture of this size",
                  .field = "/width_px"});
  }
  log().error("{}: view {} could not be drawn: {}", owner, view, failure.what());
  return Error({.code = ErrorCode::render_failed, .message = "the picture could not be drawn"});
}

}  // namespace cutaway
