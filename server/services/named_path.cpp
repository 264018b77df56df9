#include "services/named_path.h"

namespace cutaway {

namespace fs = std::filesystem;

NamedPath named_path(const fs::path& path) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) return {path, path};
  const fs::path absolute = fs::absolute(path);
  fs::path file = fs::canonical(absolute, failed);
  if (failed) file = absolute;
  return {file, file.parent_path()};
}

}  // namespace cutaway
