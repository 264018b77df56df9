#include "import/dicom/character_set.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>

#include "import/data_root.h"

namespace cutaway::reading {

namespace {

constexpr char kEscape = '\x1B';
constexpr std::string_view kUnknownCharacter = "\xEF\xBF\xBD";

/// A set of characters of one or more bytes that is called up by an escape sequence, and how iconv
/// knows it: by the high half of an encoding, `prefix` before each of its characters.
struct CodeElement {
  std::string_view escape;  ///< behind ESC
  bool is_high;             ///< G1: of bytes above 127
  int bytes;                ///< of a character
  const char* encoding;
  std::string_view prefix = {};
};

constexpr CodeElement kAscii{"(B", false, 1, "US-ASCII"};

constexpr std::array kCodeElements{
    kAscii,
    CodeElement{"(J", false, 1, "US-ASCII"},  // JIS X 0201: but for the yen sign and the overline
    CodeElement{"-A", true, 1, "ISO-8859-1"},
    CodeElement{"-B", true, 1, "ISO-8859-2"},
    CodeElement{"-C", true, 1, "ISO-8859-3"},
    CodeElement{"-D", true, 1, "ISO-8859-4"},
    CodeElement{"-L", true, 1, "ISO-8859-5"},
    CodeElement{"-G", true, 1, "ISO-8859-6"},
    CodeElement{"-F", true, 1, "ISO-8859-7"},
    CodeElement{"-H", true, 1, "ISO-8859-8"},
    CodeElement{"-M", true, 1, "ISO-8859-9"},
    CodeElement{"-b", true, 1, "ISO-8859-15"},
    CodeElement{"-T", true, 1, "TIS-620"},
    CodeElement{")I", true, 1, "SHIFT_JIS"},  // JIS X 0201, katakana
    CodeElement{"$B", false, 2, "EUC-JP"},    // JIS X 0208
    CodeElement{"$@", false, 2, "EUC-JP"},    // its first edition
    CodeElement{"$(D", false, 2, "EUC-JP", "\x8F"},
    CodeElement{"$)C", true, 2, "EUC-KR"},
    CodeElement{"$)A", true, 2, "GB2312"}};

struct NamedSet {
  std::string_view name;  ///< behind "ISO_IR " or "ISO 2022 IR "
  std::string_view escape;
};

/// Those of a byte a character, which may be there without an escape sequence.
constexpr std::array kSingleByteSets{
    NamedSet{"100", "-A"}, NamedSet{"101", "-B"}, NamedSet{"109", "-C"}, NamedSet{"110", "-D"},
    NamedSet{"144", "-L"}, NamedSet{"127", "-G"}, NamedSet{"126", "-F"}, NamedSet{"138", "-H"},
    NamedSet{"148", "-M"}, NamedSet{"203", "-b"}, NamedSet{"166", "-T"}, NamedSet{"13", ")I"},
    // Against the standard, but found: as the first value, and text that begins without an escape.
    NamedSet{"149", "$)C"}, NamedSet{"58", "$)A"}};

/// What iconv makes of it; a byte that it does not know is left out for U+FFFD.
std::string converted(std::string_view text, const char* encoding) {
  const iconv_t converter = iconv_open("UTF-8", encoding);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): iconv's own way
  if (converter == reinterpret_cast<iconv_t>(-1)) return printable(text);
  std::string input(text);
  std::string result(input.size() * 4 + 16, '\0');
  char* from = input.data();
  char* to = result.data();
  std::size_t left = input.size();
  std::size_t room = result.size();
  while (left > 0 && iconv(converter, &from, &left, &to, &room) == static_cast<std::size_t>(-1) &&
         errno != E2BIG) {
    to = std::copy(kUnknownCharacter.begin(), kUnknownCharacter.end(), to);
    room -= kUnknownCharacter.size();
    ++from;
    --left;
  }
  iconv_close(converter);
  result.resize(static_cast<std::size_t>(to - result.data()));
  return result;
}

std::string with_high_bits(std::string_view text, const CodeElement& set) {
  std::string high;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % static_cast<std::size_t>(set.bytes) == 0) high += set.prefix;
    high += static_cast<char>(static_cast<unsigned char>(text[i]) | 0x80U);
  }
  return high;
}

const CodeElement* code_element(std::string_view escape) {
  const auto found =
      std::find_if(kCodeElements.begin(), kCodeElements.end(),
                   [escape](const CodeElement& set) { return escape.starts_with(set.escape); });
  return found == kCodeElements.end() ? nullptr : &*found;
}

/// "ISO_IR 144", "ISO 2022 IR 144" and what writers make of them: their number.
std::string_view number_of(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::string_view digits = name.substr(last == name.npos ? 0 : last + 1);
  return name.find("IR") == name.npos ? std::string_view() : digits;
}

const CodeElement* first_high_set(std::string_view declared) {
  for (const auto& [name, escape] : kSingleByteSets) {
    if (number_of(declared) == name) return code_element(escape);
  }
  return nullptr;
}

std::optional<const char*> whole_encoding(std::string_view declared) {
  if (declared == "GB18030") return "GB18030";
  if (declared == "GBK") return "GBK";
  if (number_of(declared) == "192") return "UTF-8";
  return std::nullopt;
}

bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Both halves go back to the first set at these. Source: DICOM PS3.5, 6.1.2.5.3.
bool ends_designations(char c) { return c == '\\' || (c >= '\t' && c <= '\r'); }

/// Text in pieces of one set each.
class EscapedText {
 public:
  EscapedText(std::string_view text, const CodeElement* first_high)
      : text_(text), first_high_(first_high), high_(first_high) {}

  std::string decoded() {
    while (!text_.empty()) {
      if (text_.front() == kEscape) {
        take_escape();
      } else {
        result_ += piece(take_run());
      }
    }
    return result_;
  }

 private:
  void take_escape() {
    text_.remove_prefix(1);
    const CodeElement* set = code_element(text_);
    if (!set) return;
    (set->is_high ? high_ : low_) = set;
    text_.remove_prefix(set->escape.size());
  }

  /// Bytes of one half up to the next escape, or a character that ends the designations.
  std::string_view take_run() {
    const bool of_high = is_high(text_.front());
    std::size_t end = 0;
    while (end < text_.size() && text_[end] != kEscape && is_high(text_[end]) == of_high) {
      const bool ends = !of_high && low_->bytes == 1 && ends_designations(text_[end]);
      ++end;
      if (ends) break;
    }
    const std::string_view run = text_.substr(0, end);
    text_.remove_prefix(end);
    return run;
  }

  std::string piece(std::string_view run) {
    const CodeElement* set = is_high(run.front()) ? high_ : low_;
    if (!set) return printable(run);
    if (set->bytes > 1) return converted(with_high_bits(run, *set), set->encoding);
    if (ends_designations(run.back())) {
      low_ = &kAscii;
      high_ = first_high_;
    }
    return converted(run, set->encoding);
  }

  std::string_view text_;
  const CodeElement* first_high_;
  const CodeElement* low_ = &kAscii;
  const CodeElement* high_;
  std::string result_;
};

}  // namespace

CharacterSet::CharacterSet(std::string_view declared) {
  while (true) {
    const std::size_t end = declared.find('\\');
    declared_.emplace_back(trimmed(declared.substr(0, end)));
    if (end == std::string_view::npos) return;
    declared.remove_prefix(end + 1);
  }
}

std::string CharacterSet::decoded(std::string_view text) const {
  const bool is_plain =
      std::none_of(text.begin(), text.end(), [](char c) { return is_high(c) || c == kEscape; });
  if (is_plain || declared_.empty()) return printable(text);
  if (const auto encoding = whole_encoding(declared_.front()))
    return printable(converted(text, *encoding));
  const CodeElement* high = first_high_set(declared_.front());
  const bool has_escapes = text.find(kEscape) != text.npos;
  // Some writers declare a second set and call it up nowhere.
  for (std::size_t i = 1; i < declared_.size() && !high && !has_escapes; ++i)
    high = first_high_set(declared_[i]);
  if (!high && !has_escapes) return printable(text);
  return printable(EscapedText(text, high).decoded());
}

}  // namespace cutaway::reading
