// The web client's files, read into memory once: what is not among them cannot be asked for.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace cutaway {

struct StaticFile {
  std::string content;
  std::string gzip_content;  ///< from NAME.gz beside it; empty where there is none
  std::string etag;          ///< weak, since it stands for both contents
  std::string mime_type;
  bool immutable = false;  ///< its name changes with its content
};

/// Immutable after loading, so any thread may read it.
class StaticFiles {
 public:
  StaticFiles() = default;
  /// Reads every regular file under `root` that does not lead out of it. Throws Error where `root`
  /// is no folder or a file is larger than 64 MiB.
  explicit StaticFiles(const std::filesystem::path& root);

  /// `path` is decoded and begins with a slash; "/" is index.html. Null where there is no such
  /// file.
  const StaticFile* find(std::string_view path) const;
  bool empty() const { return files_.empty(); }

 private:
  std::map<std::string, StaticFile, std::less<>> files_;
};

/// Content-Type by the name's ending.
std::string_view mime_type(std::string_view path);

}  // namespace cutaway
