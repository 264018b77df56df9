// Text of DICOM elements to UTF-8. Source: DICOM PS3.5, 6.1; PS3.3, C.12.1.1.2; ISO/IEC 2022.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cutaway::reading {

/// What SpecificCharacterSet (0008,0005) of a data set declares.
class CharacterSet {
 public:
  CharacterSet() = default;
  /// `declared`: the element's text, its values parted by backslashes.
  explicit CharacterSet(std::string_view declared);

  /// Valid UTF-8, printable and trimmed. Bytes that the sets do not have become U+FFFD; those above
  /// 127 where nothing fitting is declared are taken for UTF-8 where they are some, else for
  /// ISO 8859-1.
  std::string decoded(std::string_view text) const;

 private:
  std::vector<std::string> declared_;
};

}  // namespace cutaway::reading
