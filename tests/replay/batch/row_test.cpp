#include "replay/batch/row.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(Row, ReadsBackWhatWasWritten) {
  BatchRow row;
  row.id = "a \"quoted\" id";
  row.kind = RowKind::kNotDeterministic;
  row.reasons = {"one", "two"};
  row.key = "k";
  row.result.key = "k";
  row.result.done = {ChildEnd::kMemory, 9, 1.5, 123456};
  row.result.message = "m";
  row.result.state_sha256 = "s";
  row.result.report_json = R"({"steps":3})";
  row.differences = {{"state", "/fluid/depth", HUGE_VAL, 0.25, 3, 4}};
  row.flip = 0.125;
  row.last_wall_s = 2.5;
  const Result<BatchRow> back = parse_row(row_json(row), "x");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(row_json(*back), row_json(row));
  EXPECT_EQ(back->kind, row.kind);
  EXPECT_EQ(back->result.done.end, ChildEnd::kMemory);
  EXPECT_EQ(back->result.report_json, row.result.report_json);
  EXPECT_EQ(back->differences[0].max, HUGE_VAL);
  EXPECT_EQ(back->flip, 0.125);
}

TEST(Row, WhatIsNoRowIsRefused) {
  EXPECT_EQ(parse_row("{}", "r.json").error().message, "r.json: not a row of a run");
  EXPECT_FALSE(parse_row("{", "r.json"));
}

}  // namespace
}  // namespace pentimento
