// Values of a DICOM data set, by tag.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/dicom/character_set.h"
#include "import/dicom/header.h"

namespace cutaway::reading {

/// A data set or an item of a sequence; its source, header and character set outlive it.
class DataSet {
 public:
  DataSet(ByteSource& source, const DicomItem& item, const CharacterSet& characters)
      : source_(&source), item_(&item), characters_(&characters) {}

  bool has(DicomTag tag) const { return item_->find(tag) != nullptr; }

  /// Bytes as they stand there, the first kLongestText of them; empty where absent.
  std::string raw(DicomTag tag) const;

  /// The element's text, printable and trimmed; empty where absent.
  std::string text(DicomTag tag) const;
  /// The first that is there and not empty.
  std::string first_text(std::initializer_list<DicomTag> tags) const;

  /// Of an element that is a decimal or integer string by the dictionary, whatever VR the writer
  /// gave it; NaN for what is no number. Empty where absent.
  std::vector<double> decimals(DicomTag tag) const;
  std::optional<double> decimal(DicomTag tag) const;

  /// Of an element that is binary by the dictionary (US, SS, UL, SL, FL, FD), whatever VR it has.
  std::vector<double> binaries(DicomTag tag) const;
  std::optional<double> binary(DicomTag tag) const;

  /// Of a table of 8 or 16 bits, at most `most_bytes` of it; empty where absent.
  std::string table_bytes(DicomTag tag, std::uint64_t most_bytes) const;

  std::vector<DataSet> items(DicomTag tag) const;
  std::optional<DataSet> first_item(DicomTag tag) const;

 private:
  static constexpr std::uint32_t kLongestText = 65536;

  std::vector<double> numbers(DicomTag tag, bool is_text_by_dictionary) const;

  ByteSource* source_;
  const DicomItem* item_;
  const CharacterSet* characters_;
};

/// Exactly `count` numbers, and all of them finite.
bool are_finite(const std::vector<double>& numbers, std::size_t count);

}  // namespace cutaway::reading
