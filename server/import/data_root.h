// Names: what may be opened, and what it is called on the wire.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cutaway::reading {

/// The canonical path (links resolved) of `path` where it exists inside `canonical_root`, else
/// nothing.
std::optional<std::filesystem::path> contained_path(const std::filesystem::path& path,
                                                    const std::filesystem::path& canonical_root);

/// Canonical path of a file that the header `header` names, relative to its folder. Throws Error
/// where there is none such, or where the name leads out of the data folder (the message says
/// nothing of what is there).
std::filesystem::path companion_file(const std::filesystem::path& header, std::string_view name,
                                     const std::filesystem::path& canonical_root);

/// The deepest folder that holds all of `files` (canonical, at least one): the root for a reader
/// that only knows them.
std::filesystem::path common_folder(std::span<const std::filesystem::path> files);

/// An id for `path`: relative to the root, with '/' between parts. What is unsafe in an address
/// becomes '-', and then a hash of the whole keeps ids apart.
std::string volume_id(const std::filesystem::path& path,
                      const std::filesystem::path& canonical_root);

/// FNV-1a, 8 hexadecimal digits: the same on every machine and in every release.
std::string short_hash(std::string_view text);

/// Text that is safe on the wire and in a list: valid UTF-8 without control characters, trimmed.
/// What is not UTF-8 is taken for ISO 8859-1.
std::string printable(std::string_view text);

/// ASCII lower case.
std::string lower_case(std::string_view text);
std::string_view trimmed(std::string_view text);

}  // namespace cutaway::reading
