// Formats of volumes that are known and not read: a file of one is named, not passed over.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace cutaway::reading {

/// What the file is, by its name's ending or its first bytes: "a FreeSurfer volume (MGH)". Nothing
/// for what holds no volume, as far as these tell. Opens a file without a known ending.
std::optional<std::string> foreign_format_of(const std::filesystem::path& file);

}  // namespace cutaway::reading
