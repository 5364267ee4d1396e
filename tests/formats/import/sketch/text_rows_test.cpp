#include "formats/import/sketch/text_rows.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

TEST(TextRows, CutsLinesWithAndWithoutCarriageReturns) {
  std::string_view rest = "a\r\n\nb";
  EXPECT_EQ(next_line(rest), "a");
  EXPECT_EQ(next_line(rest), "");
  EXPECT_EQ(next_line(rest), "b");
  EXPECT_TRUE(rest.empty());
}

TEST(TextRows, WordsArePartedByBlanksAndTabs) {
  EXPECT_EQ(words_of("  a \t b"), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_TRUE(words_of(" ").empty());
}

TEST(TextRows, FieldsArePartedByTheSeparatorThatTheLineHasMostOf) {
  EXPECT_EQ(separator_of("a;b;1,5"), ';');
  EXPECT_EQ(separator_of("a\tb"), '\t');
  EXPECT_EQ(separator_of("a"), ',');
  EXPECT_EQ(fields_of(" a ,\"b c\",,d", ','), (std::vector<std::string_view>{"a", "b c", "", "d"}));
}

TEST(TextRows, ANumberIsTheWholeTextAndFinite) {
  EXPECT_EQ(number_of("+1.5e2"), 150);
  EXPECT_EQ(number_of("-0.25"), -0.25);
  for (const char* text : {"", "1x", " 1", "nan", "inf", "1e999", "0x10"})
    EXPECT_FALSE(number_of(text)) << text;
}

TEST(TextRows, AByteOrderMarkIsNoText) {
  EXPECT_EQ(without_bom("\xEF\xBB\xBFx"), "x");
  EXPECT_EQ(without_bom("x"), "x");
}

TEST(TextRows, WhatIsQuotedFitsALine) {
  EXPECT_EQ(quotable("7,5 mm"), "7,5 mm");
  EXPECT_EQ(quotable("a\nb\x1B[31m\xFF"), "a?b?[31m?");
  EXPECT_EQ(quotable(std::string(41, 'x')), std::string(40, 'x') + "..");
}

}  // namespace
}  // namespace pentimento::sketch
