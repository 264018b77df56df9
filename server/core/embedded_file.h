// A file of the source tree that travels inside the executable.
#pragma once

#include <span>
#include <string_view>

namespace cutaway {

struct EmbeddedFile {
  std::string_view name;  ///< path relative to the folder it was embedded from
  std::string_view text;
};

}  // namespace cutaway
