#include "import/data_root.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

bool is_inside(const fs::path& path, const fs::path& root) {
  const auto [root_end, nothing] =
      std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  return root_end == root.end();
}

bool is_address_safe(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-' || c == '/';
}

/// Length of the UTF-8 sequence at the start of `text`, 0 where it is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and numbers above U+10FFFF are no characters.
  if (first == 0xE0 && byte(1) < 0xA0) return 0;
  if (first == 0xED && byte(1) > 0x9F) return 0;
  if (first == 0xF0 && byte(1) < 0x90) return 0;
  if (first == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string from_latin1(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xC0 | (byte >> 6));
      result += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return result;
}

}  // namespace

std::optional<fs::path> contained_path(const fs::path& path, const fs::path& canonical_root) {
  std::error_code failed;
  fs::path canonical = fs::canonical(path, failed);
  if (failed || !is_inside(canonical, canonical_root)) return std::nullopt;
  return canonical;
}

fs::path companion_file(const fs::path& header, std::string_view name,
                        const fs::path& canonical_root) {
  const fs::path named(name);
  const fs::path candidate = named.is_absolute() ? named : header.parent_path() / named;
  if (!is_inside(candidate.lexically_normal(), canonical_root)) {
    refuse(header, "the header names a file outside of the data folder",
           "a data file beside the header", printable(name));
  }
  std::error_code failed;
  const bool exists = fs::exists(candidate, failed);
  const auto contained = contained_path(candidate, canonical_root);
  if (exists && !contained) {
    refuse(header, "the header names a file outside of the data folder",
           "a data file beside the header", printable(name));
  }
  if (!contained || !fs::is_regular_file(*contained, failed)) {
    refuse(header, "the data file that the header names is not there", printable(name));
  }
  return *contained;
}

fs::path common_folder(std::span<const fs::path> files) {
  fs::path common = files.front().parent_path();
  for (const auto& file : files) {
    while (!is_inside(file, common)) common = common.parent_path();
  }
  return common;
}

std::string volume_id(const fs::path& path, const fs::path& canonical_root) {
  fs::path relative = path.lexically_relative(canonical_root);
  if (relative.empty() || relative == ".") relative = canonical_root.filename();
  const std::string text = relative.generic_string();
  std::string id = text;
  std::replace_if(
      id.begin(), id.end(), [](char c) { return !is_address_safe(c); }, '-');
  if (id != text) id += "~" + short_hash(text);
  return id.empty() ? "volume" : id;
}

std::string short_hash(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return fmt::format("{:08x}", hash);
}

std::string printable(std::string_view text) {
  std::string result = is_utf8(text) ? std::string(text) : from_latin1(text);
  std::replace_if(
      result.begin(), result.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return std::string(trimmed(result));
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank(" \t\r\n\0", 5);
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace cutaway::reading
