// scan_volumes() with the hooks that a supervised scan needs.
#pragma once

#include "import/formats.h"

namespace cutaway::reading {

/// As scan_volumes(); `context.root` is set here, from `data_root`.
Listing scan_in_context(const std::filesystem::path& path, const std::filesystem::path& data_root,
                        ScanContext context);

}  // namespace cutaway::reading
