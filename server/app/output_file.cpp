#include "app/output_file.h"

#include <unistd.h>

#include <fstream>

#include "core/error.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

Error unwritable(const fs::path& file, const std::string& why) {
  return Error({.code = ErrorCode::internal,
                .message = "the picture cannot be written",
                .field = file.string(),
                .expected = "a file in a folder that can be written to",
                .received = why});
}

}  // namespace

void check_writable(const fs::path& file) {
  std::error_code failed;
  if (fs::is_directory(file, failed)) throw unwritable(file, "a folder");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!fs::is_directory(folder, failed)) throw unwritable(file, "no such folder");
  const fs::path changed = fs::exists(file, failed) ? file : folder;
  if (access(changed.c_str(), W_OK) != 0) throw unwritable(file, "no right to write there");
}

void write_file(const fs::path& file, const std::vector<std::uint8_t>& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw unwritable(file, "a failure in writing");
}

}  // namespace cutaway
