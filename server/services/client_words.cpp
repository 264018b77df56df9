#include "services/client_words.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

/// Without links and dots; empty where that cannot be found out.
fs::path plain(const fs::path& path) {
  std::error_code failed;
  return fs::weakly_canonical(fs::absolute(path, failed), failed);
}

std::string last_part(const fs::path& path) {
  const fs::path name = path.filename();
  return (name.empty() ? path.parent_path().filename() : name).string();
}

}  // namespace

std::string path_for_client(const fs::path& path, const fs::path& root) {
  const fs::path relative = plain(path).lexically_relative(plain(root));
  const bool is_below = !relative.empty() && relative != "." && *relative.begin() != "..";
  return is_below ? relative.string() : last_part(path);
}

std::string text_for_client(std::string text, const fs::path& root) {
  const fs::path folder = plain(root);
  if (!folder.has_relative_path()) return text;
  const std::string prefix = folder.string() + "/";
  for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) {
    text.erase(at, prefix.size());
  }
  return text;
}

Error error_for_client(const Error& error, const std::string& id) {
  Error::Detail detail = error.detail();
  detail.field = "/volume";
  if (detail.expected.empty() && detail.received.empty()) detail.received = id;
  return Error(detail);
}

}  // namespace cutaway
