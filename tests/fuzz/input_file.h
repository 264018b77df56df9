// A target's input as a file, for what is only read by path.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace cutaway::fuzz {

class InputFile {
 public:
  explicit InputFile(const std::string& name) : name_(name) {
    std::filesystem::create_directories(folder_);
  }
  ~InputFile() { std::filesystem::remove_all(folder_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::filesystem::path folder() const { return folder_; }
  std::filesystem::path path() const { return folder_ / name_; }

  void write(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path(), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }

 private:
  static std::filesystem::path memory_or_disk() {
    const std::filesystem::path memory = "/dev/shm";
    return is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  }

  std::filesystem::path folder_ = memory_or_disk() / ("cutaway-fuzz-" + std::to_string(getpid()));
  std::string name_;
};

}  // namespace cutaway::fuzz
