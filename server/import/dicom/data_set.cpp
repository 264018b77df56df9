#include "import/dicom/data_set.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "import/data_root.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

template <typename T>
std::vector<double> numbers_in(std::string bytes, bool is_big_endian) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    if (is_big_endian) std::reverse(&bytes[at], &bytes[at] + sizeof(T));
    T value;
    std::memcpy(&value, &bytes[at], sizeof(T));
    numbers.push_back(static_cast<double>(value));
  }
  return numbers;
}

std::vector<double> numbers_of_text(std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t end = text.find('\\');
    const auto number = real_of(trimmed(text.substr(0, end)));
    numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return numbers;
}

enum class Kind { unknown, text, binary };

Kind kind_of(std::string_view vr) {
  for (const auto* name : {"FL", "FD", "SS", "US", "SL", "UL", "OF", "OD"})
    if (vr == name) return Kind::binary;
  for (const auto* name : {"DS", "IS", "LO", "SH", "ST", "LT", "UT", "UC", "CS", "AE", "UR"})
    if (vr == name) return Kind::text;
  return Kind::unknown;
}

std::vector<double> binaries_in(const std::string& bytes, std::string_view vr, bool is_big) {
  if (vr == "FL" || vr == "OF") return numbers_in<float>(bytes, is_big);
  if (vr == "FD" || vr == "OD") return numbers_in<double>(bytes, is_big);
  if (vr == "SS") return numbers_in<std::int16_t>(bytes, is_big);
  if (vr == "SL") return numbers_in<std::int32_t>(bytes, is_big);
  if (vr == "US") return numbers_in<std::uint16_t>(bytes, is_big);
  if (vr == "UL") return numbers_in<std::uint32_t>(bytes, is_big);
  // Implicit VR leaves only the length to tell.
  if (bytes.size() == 4) return numbers_in<std::uint32_t>(bytes, is_big);
  if (bytes.size() == 8) return numbers_in<double>(bytes, is_big);
  return numbers_in<std::uint16_t>(bytes, is_big);
}

}  // namespace

std::string DataSet::raw(DicomTag tag) const {
  const DicomElement* element = item_->find(tag);
  if (!element || element->length == 0) return {};
  return source_->read(element->offset, std::min(element->length, kLongestText));
}

std::string DataSet::text(DicomTag tag) const { return characters_->decoded(raw(tag)); }

std::string DataSet::first_text(std::initializer_list<DicomTag> tags) const {
  for (const DicomTag tag : tags) {
    if (std::string found = text(tag); !found.empty()) return found;
  }
  return {};
}

std::vector<double> DataSet::numbers(DicomTag tag, bool is_text_by_dictionary) const {
  const DicomElement* element = item_->find(tag);
  if (!element) return {};
  const std::string_view vr(element->vr.data(), 2);
  const Kind kind = kind_of(vr);
  const bool is_text = kind == Kind::text || (kind == Kind::unknown && is_text_by_dictionary);
  const std::string bytes = raw(tag);
  return is_text ? numbers_of_text(printable(bytes))
                 : binaries_in(bytes, vr, element->is_big_endian);
}

std::vector<double> DataSet::decimals(DicomTag tag) const { return numbers(tag, true); }
std::vector<double> DataSet::binaries(DicomTag tag) const { return numbers(tag, false); }

std::optional<double> DataSet::decimal(DicomTag tag) const {
  const auto found = decimals(tag);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<double> DataSet::binary(DicomTag tag) const {
  const auto found = binaries(tag);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::string DataSet::table_bytes(DicomTag tag, std::uint64_t most_bytes) const {
  const DicomElement* element = item_->find(tag);
  if (!element) return {};
  std::string bytes =
      source_->read(element->offset, std::min<std::uint64_t>(element->length, most_bytes));
  const bool is_of_words = std::string_view(element->vr.data(), 2) != "OB";
  if (element->is_big_endian && is_of_words) {
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
  }
  return bytes;
}

std::vector<DataSet> DataSet::items(DicomTag tag) const {
  std::vector<DataSet> found;
  if (const DicomElement* element = item_->find(tag)) {
    for (const auto& item : element->items) found.emplace_back(*source_, item, *characters_);
  }
  return found;
}

std::optional<DataSet> DataSet::first_item(DicomTag tag) const {
  const DicomElement* element = item_->find(tag);
  if (!element || element->items.empty()) return std::nullopt;
  return DataSet(*source_, element->items.front(), *characters_);
}

bool are_finite(const std::vector<double>& numbers, std::size_t count) {
  return numbers.size() == count &&
         std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

}  // namespace cutaway::reading
