// A path that a person has named, on the command line or in the configuration.
#pragma once

#include <filesystem>

namespace cutaway {

struct NamedPath {
  std::filesystem::path path;
  std::filesystem::path root;  ///< the folder that nothing read there may lead out of
};

/// A folder is its own root. A file's is the folder in which it really lies: one who names a link
/// means what it leads to.
NamedPath named_path(const std::filesystem::path& path);

}  // namespace cutaway
