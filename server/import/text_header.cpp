#include "import/text_header.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <utility>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::size_t kLargestHeaderBytes = std::size_t{4} << 20;
constexpr std::size_t kLargestLineBytes = std::size_t{64} << 10;
constexpr std::size_t kPieceBytes = std::size_t{16} << 10;
constexpr std::int64_t kLargestFileCount = 32768;

/// from_chars takes a minus but no plus.
template <typename T>
std::optional<T> parsed(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Where the conversion of `pattern` begins and ends, and its width.
struct Conversion {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t width = 0;
  bool zero_padded = false;
};

std::optional<Conversion> find_conversion(std::string_view pattern) {
  Conversion found{.begin = pattern.find('%')};
  if (found.begin == std::string_view::npos) return std::nullopt;
  std::size_t at = found.begin + 1;
  found.zero_padded = at < pattern.size() && pattern[at] == '0';
  for (; at < pattern.size() && pattern[at] >= '0' && pattern[at] <= '9'; ++at) {
    found.width = found.width * 10 + static_cast<std::size_t>(pattern[at] - '0');
    if (found.width > 20) return std::nullopt;
  }
  if (at >= pattern.size() || pattern[at] != 'd') return std::nullopt;
  found.end = at + 1;
  if (pattern.find('%', found.end) != std::string_view::npos) return std::nullopt;
  return found;
}

std::string with_number(std::string_view pattern, const Conversion& place, std::int64_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() < place.width) {
    digits.insert(0, place.width - digits.size(), place.zero_padded ? '0' : ' ');
  }
  return std::string(pattern.substr(0, place.begin)) + digits +
         std::string(pattern.substr(place.end));
}

/// "slice%03d.raw 1 99 1" to its names, "slice%03d.raw 99 1 -1" in falling order; one name alone to
/// itself. Of conversions only one of an integer is taken.
std::vector<std::string> expand_file_pattern(const std::filesystem::path& file,
                                             std::string_view text) {
  if (text.find('%') == std::string_view::npos) return {std::string(text)};
  const std::vector<std::string> words = words_of(text);
  const auto place = find_conversion(words.empty() ? std::string_view() : words.front());
  const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : std::string(); };
  const auto number = [&](std::size_t i) {
    const auto value = integer_of(word(i));
    constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();
    const bool is_small = value && *value <= kLargest && *value >= -kLargest;
    return is_small ? value : std::nullopt;
  };
  const std::int64_t first = number(1).value_or(-1);
  const std::int64_t last = number(2).value_or(-1);
  const std::int64_t step = words.size() > 3 ? number(3).value_or(0) : 1;
  const std::int64_t way = step > 0 ? last - first : first - last;
  const bool usable = place && step != 0 && first >= 0 && last >= 0 && way >= 0 &&
                      way / std::abs(step) < kLargestFileCount;
  if (!usable) {
    refuse(file, "the pattern of data file names is not usable", "name%03d.raw first last step",
           printable(text));
  }
  std::vector<std::string> names;
  for (std::int64_t i = 0; i <= way / std::abs(step); ++i) {
    names.push_back(with_number(words.front(), *place, first + i * step));
  }
  return names;
}

}  // namespace

std::optional<std::string> TextHeader::find(std::string_view name) const {
  const auto found = fields.find(name);
  if (found == fields.end()) return std::nullopt;
  return found->second;
}

HeaderLines::HeaderLines(const std::filesystem::path& file) : input_(file, std::ios::binary) {
  if (!input_) refuse(file, "the file cannot be opened");
  if (!read_on()) refuse(file, "the file is empty");
}

std::optional<std::string> HeaderLines::next() {
  std::size_t end = ahead_.find('\n', taken_);
  while (end == std::string::npos && read_on()) end = ahead_.find('\n', taken_);
  const std::size_t stop = std::min(end, ahead_.size());
  if (taken_ >= ahead_.size() || stop - taken_ > kLargestLineBytes) return std::nullopt;
  std::string line = ahead_.substr(taken_, stop - taken_);
  const std::size_t after = std::min(stop + 1, ahead_.size());
  position_ += after - std::exchange(taken_, after);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

// Voxels may follow the header: of them no more is read than lies in its last piece.
bool HeaderLines::read_on() {
  ahead_.erase(0, std::exchange(taken_, 0));
  if (ahead_.size() > kLargestLineBytes) return false;
  const std::size_t before = ahead_.size();
  const std::size_t left = kLargestHeaderBytes - static_cast<std::size_t>(position_) - before;
  ahead_.resize(before + std::min(kPieceBytes, left));
  input_.read(ahead_.data() + before, static_cast<std::streamsize>(ahead_.size() - before));
  ahead_.resize(before + static_cast<std::size_t>(input_.gcount()));
  return ahead_.size() > before;
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const auto& word : words_of(text)) {
    numbers.push_back(real_of(word).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return numbers;
}

std::optional<double> real_of(std::string_view text) { return parsed<double>(text); }

std::optional<std::int64_t> integer_of(std::string_view text) { return parsed<std::int64_t>(text); }

std::vector<std::filesystem::path> named_data_files(const std::filesystem::path& header,
                                                    const std::string& named,
                                                    const TextHeader& text,
                                                    const std::filesystem::path& root) {
  const std::vector<std::string> names =
      named.starts_with("LIST") ? text.further_lines : expand_file_pattern(header, named);
  if (names.empty()) refuse(header, "the header names no data file");
  std::vector<std::filesystem::path> paths;
  paths.reserve(names.size());
  for (const auto& name : names) paths.push_back(companion_file(header, name, root));
  return paths;
}

}  // namespace cutaway::reading
