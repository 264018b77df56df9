// Text in the character sets of DICOM. Source: DICOM PS3.5, 6.1 and annexes H to K.
#include <gtest/gtest.h>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

struct Text {
  const char* declared;
  std::string bytes;
  std::string expected;
};

std::string title_of(const Text& text) {
  auto slices = with_text(ramp_series(2, {0, 0, 0}, {0, 0, 2}), {0x0008, 0x103e}, text.bytes);
  TemporaryFolder folder;
  write_series(folder.path(), with_text(std::move(slices), {0x0008, 0x0005}, text.declared));
  return only_source(folder.path(), folder.path()).description.title;
}

TEST(DicomText, OfOneByteACharacterIsRead) {
  const Text texts[]{{"ISO_IR 100",
                      "Sch\xE4"
                      "del",
                      "Schädel"},
                     {"ISO_IR 101",
                      "\xE8"
                      "e\xB9tina",
                      "čeština"},
                     {"ISO_IR 109", "\xE6", "ĉ"},
                     {"ISO_IR 110", "\xBE", "ž"},
                     {"ISO_IR 144", "\xB3\xDE\xDB\xDE\xD2\xD0 \xBA\xC2", "Голова КТ"},
                     {"ISO_IR 127", "\xE2\xC8\xC7\xE6\xEA", "قباني"},
                     {"ISO_IR 126", "\xC4\xE9\xEF\xED", "Διον"},
                     {"ISO_IR 138", "\xF9\xF8\xE5\xEF", "שרון"},
                     {"ISO_IR 148", "\xC7\xFD", "Çı"},
                     {"ISO_IR 203", "\xA4", "€"},
                     {"ISO_IR 166", "\xA1\xD2", "กา"},
                     {"ISO_IR 13", "\xD4\xCF\xC0\xDE", "ﾔﾏﾀﾞ"},
                     {"ISO_IR 192", "頭部", "頭部"}};
  for (const auto& text : texts) EXPECT_EQ(title_of(text), text.expected) << text.declared;
}

TEST(DicomText, InChineseSetsIsReadWithBackslashesAsSecondBytes) {
  EXPECT_EQ(title_of({"GB18030", "\xCD\xB7\xB2\xBF\xD4\xF6\xC7\xBF\xC9\xA8\xC3\xE8", ""}),
            "头部增强扫描");
  EXPECT_EQ(title_of({"GB18030", "\x81\x30\x84\x36", ""}), "¥");
  EXPECT_EQ(title_of({"GBK", "\x81\x5C\xCD\xB7", ""}), "乗头");
}

TEST(DicomText, FollowsEscapeSequences) {
  const Text texts[]{
      {"\\ISO 2022 IR 87", "\x1B$BF,It\x1B(B", "頭部"},
      {"\\ISO 2022 IR 87", "CT \x1B$BF,It\x1B(B 5 mm", "CT 頭部 5 mm"},
      {"ISO 2022 IR 13\\ISO 2022 IR 87", "\xD4\xCF\xC0\xDE \x1B$B;3ED\x1B(J", "ﾔﾏﾀﾞ 山田"},
      {"\\ISO 2022 IR 159", "\x1B$(D0!\x1B(B", "丂"},
      {"\\ISO 2022 IR 149", "\x1B$)C\xB1\xE8\xC8\xF1\xC1\xDF CT", "김희중 CT"},
      {"\\ISO 2022 IR 58", "\x1B$)A\xCD\xF5 MR", "王 MR"},
      {"ISO 2022 IR 100\\ISO 2022 IR 144", "\xE4 \x1B-L\xB3", "ä Г"},
      {"ISO 2022 IR 6\\ISO 2022 IR 126", "\x1B-F\xC4", "Δ"}};
  for (const auto& text : texts) EXPECT_EQ(title_of(text), text.expected) << text.declared;
}

TEST(DicomText, DesignationsEndWithTheValue) {
  EXPECT_EQ(title_of({"ISO 2022 IR 100\\ISO 2022 IR 144", "\x1B-L\xB3\\\xE4", ""}), "Г\\ä");
}

TEST(DicomText, ThatIsNotDeclaredIsGuessed) {
  EXPECT_EQ(title_of({"",
                      "Sch\xE4"
                      "del",
                      ""}),
            "Schädel");
  EXPECT_EQ(title_of({"", "Schädel", ""}), "Schädel");
  EXPECT_EQ(title_of({"ISO_IR 999",
                      "Sch\xE4"
                      "del",
                      ""}),
            "Schädel");
}

TEST(DicomText, ThatIsBrokenIsStillText) {
  EXPECT_EQ(title_of({"GB18030", "\xCD\xB7\xFF", ""}), "头\xEF\xBF\xBD");
  EXPECT_EQ(title_of({"\\ISO 2022 IR 87", "A\x1B$ZB", ""}), "A$ZB");
}

}  // namespace
}  // namespace cutaway::test
