#include "core/check.h"

#include <cstdlib>

#include "core/log.h"

namespace cutaway {

void check_failed(std::string_view what, const std::string& values, std::source_location where) {
  log().critical("check failed: {}{}{} at {}:{}", what, values.empty() ? "" : ": ", values,
                 where.file_name(), where.line());
  log().flush();
  std::abort();
}

}  // namespace cutaway
