#include "formats/log/json/json_fault.h"

#include <gtest/gtest.h>

namespace pentimento::log {
namespace {

TEST(JsonFault, IsNothingInJson) {
  for (const char* right :
       {"{}", R"({"a":[1,-2.5e3,true,null,"\u00fc // no comment, NaN"]})", " 1 "})
    EXPECT_EQ(json_fault(right), "") << right;
}

TEST(JsonFault, NamesTheHabitsOfOtherNotations) {
  EXPECT_EQ(json_fault(R"({"t":NaN})"), "column 6: NaN is not a number of JSON");
  EXPECT_EQ(json_fault(R"({"t":-Infinity})"), "column 7: Infinity is not a number of JSON");
  EXPECT_EQ(json_fault("# a comment"), "column 1: JSON has no comments");
  EXPECT_EQ(json_fault(R"({"t":1 /* one */})"), "column 8: JSON has no comments");
  EXPECT_EQ(json_fault(R"({"a":[1, ]})"), "column 10: a comma before ]");
  EXPECT_EQ(json_fault("{'t':1}"), "column 2: JSON has double quotes, not single ones");
}

TEST(JsonFault, NamesOtherFaultsInTheParsersWords) {
  EXPECT_EQ(json_fault(R"({"t" 1})"), "column 6: unexpected number literal; expected ':'");
  EXPECT_EQ(json_fault(R"({"t":5.})"), "column 8: invalid number; expected digit after '.'");
}

TEST(JsonFault, CountsCharactersNotBytes) {
  EXPECT_EQ(json_fault("{\"\xc3\xbc\":NaN}"), json_fault(R"({"u":NaN})"));
}

TEST(JsonFault, OfADeepOrAnEmptyLineIsFoundToo) {
  EXPECT_EQ(json_fault(std::string(1'000'000, '[')),
            "column 1000000: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_NE(json_fault(""), "");
}

}  // namespace
}  // namespace pentimento::log
