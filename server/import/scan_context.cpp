#include "import/scan_context.h"

#include <new>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

void ScanContext::announce(const std::filesystem::path& file) const {
  throw_if_cancelled(stop);
  if (on_file) on_file(file);
}

void ScanContext::require_openable(const std::filesystem::path& file) const {
  if (const auto known = given_up.find(file); known != given_up.end()) refuse(file, known->second);
  if (only_opened && !opened.contains(file)) {
    refuse(file, "not looked at, since too many other files here stopped their reader");
  }
}

/// Of libraries, or of memory: one file's misfortune, not that of the folder.
void ScanContext::rethrow_as_error(const std::filesystem::path& file,
                                   const std::exception& failure) {
  if (const auto* error = dynamic_cast<const Error*>(&failure)) throw Error(*error);
  if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr) {
    refuse(file, "there is not enough memory to look into the file");
  }
  refuse(file, "the file cannot be looked into", {}, printable(failure.what()));
}

}  // namespace cutaway::reading
