#include "replay/job/stop_points.h"

#include <gtest/gtest.h>

#include "tests/replay/list_reader.h"

namespace pentimento {
namespace {

using test::ListReader;

Result<std::vector<std::int64_t>> resolve(const ListReader& reader,
                                          const std::vector<std::string>& texts,
                                          std::int64_t steps) {
  std::vector<StopPoint> points;
  for (const std::string& text : texts) points.push_back(parse_stop_point(text).value());
  StopFinder finder(points);
  for (const log::Event& event : reader.events) finder.add(event);
  return finder.resolve(reader.head.steps_per_second, steps);
}

TEST(StopPoints, OtherTextsAreRefused) {
  for (const char* text :
       {"", "x", "1s", "-1", "nan", "inf", "step:", "step:-1", "step:1.5", "mark:", "1e300"}) {
    const Result<StopPoint> point = parse_stop_point(text);
    ASSERT_FALSE(point.ok()) << text;
    EXPECT_EQ(point.error().code, ErrorCode::kUsage);
  }
}

TEST(StopPoints, ATimeOrMarkMeansTheEndOfItsStep) {
  ListReader reader;  // 45 steps a second
  reader.add(0.5, log::Mark{"half"});
  reader.add(2.0, log::Gravity{});
  const auto stops = resolve(reader, {"0", "1", "mark:half", "step:10"}, 91);
  ASSERT_TRUE(stops.ok());
  EXPECT_EQ(*stops, (std::vector<std::int64_t>{1, 46, 23, 10}));
}

TEST(StopPoints, InALogOfStepsTheyCountThem) {
  ListReader reader;
  reader.add(0.0, log::Step{});
  reader.add(0.0, log::Mark{"m"});
  reader.add(0.1, log::Step{});
  reader.add(0.2, log::Step{});
  const auto stops = resolve(reader, {"mark:m", "0.1", "0.2"}, 3);
  ASSERT_TRUE(stops.ok());
  EXPECT_EQ(*stops, (std::vector<std::int64_t>{2, 3, 3}));
}

TEST(StopPoints, AMarkThatIsSetTwiceIsTheFirst) {
  ListReader reader;
  reader.add(0.5, log::Mark{"m"});
  reader.add(1.0, log::Mark{"n"});
  reader.add(1.5, log::Mark{"m"});
  EXPECT_EQ(*resolve(reader, {"mark:m", "mark:n"}, 68), (std::vector<std::int64_t>{23, 46}));
}

TEST(StopPoints, TheEndOfTheLogIsInIt) {
  ListReader reader;
  reader.add(1.0, log::Mark{"end"});
  EXPECT_EQ(*resolve(reader, {"1", "step:46", "step:0"}, 46),
            (std::vector<std::int64_t>{46, 46, 0}));
}

TEST(StopPoints, WhatIsNotInTheLogIsRefused) {
  ListReader reader;
  reader.add(1.0, log::Mark{"end"});
  EXPECT_FALSE(resolve(reader, {"mark:End"}, 46).ok());
  EXPECT_FALSE(resolve(reader, {"1.1"}, 46).ok());
  EXPECT_FALSE(resolve(reader, {"step:47"}, 46).ok());
}

TEST(StopPoints, LabelsAreFitForFileNames) {
  EXPECT_EQ(parse_stop_point("mark:a/b").value().label, "a_b");
  EXPECT_EQ(parse_stop_point("step:12").value().label, "12");
  EXPECT_EQ(parse_stop_point("1.5").value().label, "1.5");
}

}  // namespace
}  // namespace pentimento
