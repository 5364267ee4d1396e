#include "replay/output/output_plan.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

std::vector<StopPoint> stops(const std::vector<std::string>& texts) {
  std::vector<StopPoint> points;
  for (const std::string& text : texts) points.push_back(parse_stop_point(text).value());
  return points;
}

TEST(OutputPlan, TheExtensionSaysWhatIsWritten) {
  const auto plan = plan_outputs({"a.png", "b.EXR", "c.h5", "-"}, {});
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->size(), 1u);
  EXPECT_EQ((*plan)[0][0].kind, OutputKind::kPng);
  EXPECT_EQ((*plan)[0][1].kind, OutputKind::kExr);
  EXPECT_EQ((*plan)[0][2].kind, OutputKind::kState);
  EXPECT_EQ((*plan)[0][3].kind, OutputKind::kPng);
}

TEST(OutputPlan, APercentSignStandsForTheStop) {
  const auto plan = plan_outputs({"f-%.png", "%/%.exr"}, stops({"1.5", "step:7", "mark:glaze"}));
  ASSERT_TRUE(plan.ok());
  EXPECT_EQ((*plan)[2][1].path, "glaze/glaze.exr");  // every sign
  EXPECT_EQ((*plan)[0][0].path, "f-1.5.png");
  EXPECT_EQ((*plan)[1][0].path, "f-7.png");
  EXPECT_EQ((*plan)[2][0].path, "f-glaze.png");
}

TEST(OutputPlan, WhatCannotBeIsRefused) {
  EXPECT_FALSE(plan_outputs({"a.jpg"}, {}).ok());
  EXPECT_FALSE(plan_outputs({"a.png", "./a.png"}, {}).ok());
  EXPECT_FALSE(plan_outputs({"a.png"}, stops({"1", "2"})).ok());
  EXPECT_FALSE(plan_outputs({"%.png"}, stops({"1", "step:1"})).ok());  // both are 1.png
}

TEST(OutputPlan, WithoutPatternsHasPointsButNoFiles) {
  const auto plan = plan_outputs({}, stops({"1", "2"}));
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->size(), 2u);
  EXPECT_TRUE(plan->front().empty() && plan->back().empty());
}

}  // namespace
}  // namespace pentimento
