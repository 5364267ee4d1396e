#include "formats/io/utf8.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

const std::string kBad = "\xEF\xBF\xBD";  // U+FFFD

// The ends of each row of Unicode 15, table 3-7, and what lies just beyond.
TEST(ValidUtf8, KeepsTheFirstAndTheLastOfEachLength) {
  for (const char* text : {"\x01", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xEC\xBF\xBF",
                           "\xED\x9F\xBF", "\xEE\x80\x80", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(valid_utf8(text), text);
}

TEST(ValidUtf8, ReplacesEachByteOfWhatIsNoCharacter) {
  EXPECT_EQ(valid_utf8("\xC1\xBF"), kBad + kBad) << "overlong";
  EXPECT_EQ(valid_utf8("\xE0\x9F\xBF"), kBad + kBad + kBad) << "overlong";
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), kBad + kBad + kBad) << "a surrogate";
  EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80"), kBad + kBad + kBad + kBad) << "beyond U+10FFFF";
  EXPECT_EQ(valid_utf8("a\xE2\x82"), "a" + kBad + kBad) << "cut off";
  EXPECT_EQ(valid_utf8(std::string_view("a\0b", 3)), "a" + kBad + "b");
}

TEST(OneLine, HasNoCharacterThatATerminalObeys) {
  EXPECT_EQ(one_line("a\x1b[31m\tb\n\x7f"), "a [31m b  ");
  EXPECT_EQ(one_line("a\xC2\x80\xC2\x9B"
                     "31m"),
            "a  31m");
  EXPECT_EQ(one_line("\xC2\xA0\xC3\x9B\xE2\x82\x80"), "\xC2\xA0\xC3\x9B\xE2\x82\x80")
      << "characters with such bytes in them";
  EXPECT_EQ(one_line("\xC2"), "\xC2");
}

TEST(BriefLine, KeepsBothEndsAndNoPartOfACharacter) {
  EXPECT_EQ(brief_line("123456789", 9), "123456789");
  EXPECT_EQ(brief_line("0123456789abcdef", 9), "0123..def");
  EXPECT_EQ(brief_line("012\xC3\xA9"
                       "456789abc\xC3\xA9"
                       "f",
                       9),
            "012..\xC3\xA9"
            "f");
  EXPECT_EQ(brief_line("0123456789abcd\xC3\xA9"
                       "f",
                       8),
            "0123..f")
      << "cut within a character";
  EXPECT_EQ(brief_line("a\nb\x1f", 9), "a b ");
  EXPECT_EQ(brief_line(std::string(1000, 'a'), 300).size(), 300U);
}

}  // namespace
}  // namespace pentimento
