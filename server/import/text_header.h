// The text headers of NRRD and MetaImage: fields by name, and the files that they point to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/reader.h"

namespace cutaway::reading {

struct TextHeader {
  std::map<std::string, std::string, std::less<>> fields;
  std::vector<std::string>
      further_lines;        ///< after a field that ends the header and announces a list
  std::uint64_t bytes = 0;  ///< where attached voxels begin

  std::optional<std::string> find(std::string_view name) const;
};

/// The lines at the start of a file, without their ends: nothing more after 4 MiB or at a line of
/// over 64 KiB, which no header has. Throws Error naming `file` where it is empty.
class HeaderLines {
 public:
  explicit HeaderLines(const std::filesystem::path& file);
  std::optional<std::string> next();
  std::uint64_t position() const { return position_; }

 private:
  bool read_on();

  std::ifstream input_;
  std::string ahead_;           ///< read, from before `position_` on
  std::size_t taken_ = 0;       ///< of `ahead_`
  std::uint64_t position_ = 0;  ///< in the file
};

/// Words parted by blanks. Numbers that are none give NaN, so that a check sees them.
std::vector<std::string> words_of(std::string_view text);
std::vector<double> numbers_of(std::string_view text);

/// One number and nothing else, with or without a sign.
std::optional<double> real_of(std::string_view text);
std::optional<std::int64_t> integer_of(std::string_view text);

/// The data files of a header, canonical: `named` is the value of its field, a name, a pattern, or
/// LIST with the names in further lines. Throws Error naming the header where one is not there or
/// outside of `root`.
std::vector<std::filesystem::path> named_data_files(const std::filesystem::path& header,
                                                    const std::string& named,
                                                    const TextHeader& text,
                                                    const std::filesystem::path& root);

}  // namespace cutaway::reading
