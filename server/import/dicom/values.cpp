#include "import/dicom/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr DicomTag kRescaleIntercept = 0x00281052;
constexpr DicomTag kRescaleSlope = 0x00281053;
constexpr DicomTag kRescaleType = 0x00281054;
constexpr DicomTag kModalityTables = 0x00283000;

/// As the file calls them; "none" for the terms that say that there is none.
std::string units_named(const std::string& term) {
  constexpr std::size_t kLongest = 32;  // of a term that the protocol carries
  if (term == "[hnsf'U]") return "HU";
  for (const auto* none : {"", "US", "UNSPECIFIED", "NONE", "normalized", "NORMALIZED", "1"})
    if (term == none) return "none";
  return quoted_briefly(term, kLongest - 3);
}

/// Bytes, words, or bytes with a word each. Source: DICOM PS3.3, C.11.1.1.1.
std::vector<std::uint16_t> entries_in(const std::string& bytes, std::size_t count, int bits) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::vector<std::uint16_t> entries;
  const bool is_of_bytes = bits <= 8 && bytes.size() < 2 * count;
  if (bytes.size() < (is_of_bytes ? count : 2 * count)) return entries;
  entries.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int entry = is_of_bytes ? byte(i) : byte(2 * i) | byte(2 * i + 1) << 8;
    entries.push_back(static_cast<std::uint16_t>(entry));
  }
  return entries;
}

ValueTable table_in(const std::filesystem::path& file, const DataSet& data, const DataSet& item) {
  const auto descriptor = item.binaries(0x00283002);
  constexpr std::size_t kMostBytes = 131072;
  if (!are_finite(descriptor, 3)) {
    refuse(file, "the Modality LUT has no usable descriptor", "3 numbers",
           fmt::format("{}", fmt::join(descriptor, ", ")));
  }
  const auto word = [](double number) { return static_cast<std::uint16_t>(std::llround(number)); };
  const std::size_t count = word(descriptor[0]) == 0 ? 65536 : word(descriptor[0]);
  const bool is_signed = data.binary(0x00280103).value_or(0) == 1;
  ValueTable table;
  table.first_stored = is_signed ? static_cast<std::int16_t>(word(descriptor[1]))
                                 : static_cast<std::int32_t>(word(descriptor[1]));
  table.entries =
      entries_in(item.table_bytes(0x00283006, kMostBytes), count, static_cast<int>(descriptor[2]));
  if (table.entries.empty())
    refuse(file, "the Modality LUT is shorter than its descriptor says",
           fmt::format("{} entries", count));
  return table;
}

std::optional<DataSet> first_with(const std::vector<DataSet>& groups, DicomTag tag) {
  for (const auto& group : groups) {
    if (group.has(tag)) return group;
  }
  return std::nullopt;
}

void apply_rescale(const std::filesystem::path& file, const DataSet& group, bool is_ct,
                   ValueMeaning& meaning) {
  meaning.slope = group.decimal(kRescaleSlope).value_or(1.0);
  meaning.intercept = group.decimal(kRescaleIntercept).value_or(0.0);
  if (!std::isfinite(meaning.slope) || meaning.slope == 0.0 || !std::isfinite(meaning.intercept)) {
    refuse(file, "the rescale of the values is not usable",
           "a finite slope other than 0 and a finite intercept",
           fmt::format("{} and {}", meaning.slope, meaning.intercept));
  }
  const std::string type = group.text(kRescaleType);
  meaning.units = type.empty() && is_ct ? "HU" : units_named(type);
  meaning.is_stated = true;
}

/// Linear mappings alone. Where there is a rescale, only the units of one that says the same.
void apply_real_world(const DataSet& group, ValueMeaning& meaning) {
  const auto item = group.first_item(0x00409096);
  const auto slope = item ? item->binary(0x00409225) : std::nullopt;
  const auto intercept = item ? item->binary(0x00409224) : std::nullopt;
  if (!slope || !intercept || !std::isfinite(*slope) || *slope == 0 || !std::isfinite(*intercept))
    return;
  const bool agrees = meaning.slope == *slope && meaning.intercept == *intercept;
  if (meaning.is_stated && (!agrees || meaning.units != "none")) return;
  meaning.is_real_world = !meaning.is_stated;
  meaning.slope = *slope;
  meaning.intercept = *intercept;
  meaning.is_stated = true;
  if (const auto units = item->first_item(0x004008EA))
    meaning.units = units_named(units->text(0x00080100));
}

}  // namespace

double ValueTable::value_of(double stored) const {
  if (!(stored >= first_stored)) return entries.front();
  const double last = static_cast<double>(entries.size() - 1);
  return entries[static_cast<std::size_t>(std::clamp(stored - first_stored, 0.0, last))];
}

bool ValueMeaning::operator==(const ValueMeaning& other) const {
  if (!table != !other.table || (table && !(*table == *other.table))) return false;
  return slope == other.slope && intercept == other.intercept;
}

ValueMeaning value_meaning(const std::filesystem::path& file, const DataSet& data,
                           const std::vector<DataSet>& groups, bool is_hounsfield_by_default) {
  ValueMeaning meaning;
  if (const auto item = data.first_item(kModalityTables)) {
    meaning.table = std::make_shared<const ValueTable>(table_in(file, data, *item));
    meaning.units = units_named(item->text(0x00283004));
    meaning.is_stated = true;
    return meaning;
  }
  auto rescaled = first_with(groups, kRescaleSlope);
  if (!rescaled) rescaled = first_with(groups, kRescaleIntercept);
  if (rescaled) apply_rescale(file, *rescaled, is_hounsfield_by_default, meaning);
  if (const auto mapped = first_with(groups, 0x00409096)) apply_real_world(*mapped, meaning);
  const std::string counted = data.text(0x00541001);
  if (meaning.units == "none" && !counted.empty()) meaning.units = units_named(counted);
  return meaning;
}

std::optional<ValueRange> window_of(const std::vector<DataSet>& groups,
                                    const ValueMeaning& meaning) {
  const auto group = first_with(groups, 0x00281050);
  if (!group) return std::nullopt;
  const auto centres = group->decimals(0x00281050);
  const auto widths = group->decimals(0x00281051);
  if (centres.empty() || widths.empty()) return std::nullopt;
  const double half_width = 0.5 * widths.front();
  ValueRange window{centres.front() - half_width, centres.front() + half_width};
  if (meaning.is_real_world) {
    const double ends[]{window.minimum * meaning.slope + meaning.intercept,
                        window.maximum * meaning.slope + meaning.intercept};
    window = {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
  }
  const bool is_usable = std::isfinite(window.minimum) && std::isfinite(window.maximum) &&
                         window.maximum > window.minimum;
  return is_usable ? std::optional(window) : std::nullopt;
}

}  // namespace cutaway::reading
