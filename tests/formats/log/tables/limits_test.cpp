#include "formats/log/tables/limits.h"

#include <gtest/gtest.h>

#include <set>

namespace pentimento::log {
namespace {

TEST(Limits, EveryRowHasItsOwnNameReasonAndOption) {
  std::set<std::string_view> names, options;
  for (const LimitRow& row : limit_rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(options.insert(row.option).second) << row.option;
    EXPECT_FALSE(row.reason.empty()) << row.name;
    EXPECT_GT(Limits().*row.value, 0) << row.name;
  }
}

TEST(Limits, AnyCanBeSetByItsName) {
  Limits limits;
  for (const LimitRow& row : limit_rows()) {
    EXPECT_EQ(set_limit(limits, std::string(row.name) + "=12345"), "");
    EXPECT_EQ(limits.*row.value, 12345) << row.name;
  }
}

TEST(Limits, WhatIsNoSettingIsSaid) {
  Limits limits;
  EXPECT_NE(set_limit(limits, "stamp=5").find("\"stamps\""), std::string::npos);
  for (const char* wrong : {"", "stamps", "stamps=", "stamps=x", "stamps=1e9", "stamps=0",
                            "stamps=-1", "stamps=99999999999999999999"})
    EXPECT_NE(set_limit(limits, wrong), "") << wrong;
  EXPECT_EQ(limits.max_stamps, Limits().max_stamps);
}

TEST(Limits, ANoteNamesTheOption) {
  EXPECT_EQ(limit_note(&Limits::max_events), ", the limit (--max-events)");
  EXPECT_EQ(limit_note(&Limits::max_stamps), ", the limit (--limit stamps=N)");
}

}  // namespace
}  // namespace pentimento::log
