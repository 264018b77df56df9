#include "net/static_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/error.h"
#include "core/log.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{64} << 20;
constexpr std::string_view kHashedFolder = "/assets/";  // the bundler puts a hash in these names

using MimeType = std::pair<std::string_view, std::string_view>;
constexpr std::array kMimeTypes = {
    MimeType{".html", "text/html; charset=utf-8"},
    MimeType{".js", "text/javascript; charset=utf-8"},
    MimeType{".mjs", "text/javascript; charset=utf-8"},
    MimeType{".css", "text/css; charset=utf-8"},
    MimeType{".json", "application/json"},
    MimeType{".map", "application/json"},
    MimeType{".webmanifest", "application/manifest+json"},
    MimeType{".svg", "image/svg+xml"},
    MimeType{".png", "image/png"},
    MimeType{".jpg", "image/jpeg"},
    MimeType{".webp", "image/webp"},
    MimeType{".ico", "image/x-icon"},
    MimeType{".woff2", "font/woff2"},
    MimeType{".wasm", "application/wasm"},
    MimeType{".txt", "text/plain; charset=utf-8"},
};

// FNV-1a, 64 bit: tells versions of a file apart; nothing secret hangs on it.
std::string etag_of(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : content) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3;
  }
  return fmt::format("W/\"{:016x}-{:x}\"", hash, content.size());
}

std::string read_whole(const fs::path& path) {
  if (fs::file_size(path) > kLargestFile) {
    throw Error({.code = ErrorCode::too_large,
                 .message = "a file of the web client is too large",
                 .field = path.string(),
                 .expected = std::to_string(kLargestFile) + " bytes at most",
                 .received = std::to_string(fs::file_size(path)) + " bytes"});
  }
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool leads_out(const fs::path& root, const fs::path& path) {
  const fs::path relative = fs::canonical(path).lexically_relative(root);
  return relative.empty() || *relative.begin() == "..";
}

StaticFile read_file(const fs::path& path, const std::string& url) {
  StaticFile file;
  file.content = read_whole(path);
  file.etag = etag_of(file.content);
  file.mime_type = mime_type(url);
  file.immutable = url.starts_with(kHashedFolder);
  fs::path compressed = path;
  compressed += ".gz";
  if (fs::is_regular_file(compressed)) file.gzip_content = read_whole(compressed);
  return file;
}

}  // namespace

StaticFiles::StaticFiles(const fs::path& root) {
  if (!fs::is_directory(root)) {
    throw Error({.code = ErrorCode::out_of_range,
                 .message = "the web client's folder cannot be read",
                 .field = root.string(),
                 .expected = "a folder with index.html"});
  }
  const fs::path canonical_root = fs::canonical(root);
  for (const auto& entry : fs::recursive_directory_iterator(canonical_root)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".gz") continue;
    if (leads_out(canonical_root, entry.path())) {
      log().warn("web client: {} leads out of its folder and is left out", entry.path().string());
      continue;
    }
    const std::string url = "/" + entry.path().lexically_relative(canonical_root).generic_string();
    files_.emplace(url, read_file(entry.path(), url));
  }
}

const StaticFile* StaticFiles::find(std::string_view path) const {
  const auto file = files_.find(path == "/" ? std::string_view("/index.html") : path);
  return file == files_.end() ? nullptr : &file->second;
}

std::string_view mime_type(std::string_view path) {
  const auto found = std::ranges::find_if(
      kMimeTypes, [path](const MimeType& type) { return path.ends_with(type.first); });
  return found == kMimeTypes.end() ? "application/octet-stream" : found->second;
}

}  // namespace cutaway
