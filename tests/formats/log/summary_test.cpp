#include "formats/log/summary.h"

#include <gtest/gtest.h>

#include "formats/io/sha256.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

TEST(Summary, CountsWhatALogHolds) {
  const std::string text = kHeaderLine +
                           R"({"t":0,"type":"color","value":"#ff0000"})"
                           "\n"
                           R"({"t":0,"type":"color","value":"#ff0000"})"
                           "\n"
                           R"({"t":0,"type":"touch","phase":"down","x":0.1,"y":0.7,"pressure":1})"
                           "\n"
                           R"({"t":1,"type":"touch","phase":"down","id":2,"x":-0.1,"y":0.2})"
                           "\n"
                           R"({"t":1,"type":"touch","phase":"cancel","x":0.1,"y":0.2})"
                           "\n"
                           R"({"t":1,"type":"load","file":"a.png"})"
                           "\n"
                           R"({"t":2,"type":"mark","name":"m"})"
                           "\n"
                           R"({"t":2.5,"type":"x-a"})"
                           "\n";
  const TemporaryFolder folder;
  auto reader = Reader::open(folder.write("a.jsonl", text), {});
  ASSERT_TRUE(reader.ok());
  const Result<Summary> result = summarize(**reader);
  ASSERT_TRUE(result.ok()) << result.error().message;
  const Summary& summary = *result;
  EXPECT_EQ(summary.event_count, 8);
  EXPECT_EQ(summary.events.at("touch"), 3);
  EXPECT_EQ(summary.events.at("x-"), 1);
  EXPECT_FALSE(summary.events.contains("dry"));
  EXPECT_EQ(summary.duration_s(), 2.5);
  EXPECT_EQ(summary.strokes, 2);
  EXPECT_EQ(summary.cancelled, 1);
  EXPECT_EQ(summary.most_touches, 2);
  EXPECT_EQ(summary.still_down, 1);
  EXPECT_TRUE(summary.has_pressure);
  EXPECT_FALSE(summary.has_tilt);
  EXPECT_EQ(summary.bounds.min_x_m, -0.1);
  EXPECT_EQ(summary.bounds.max_x_m, 0.1);
  EXPECT_EQ(summary.bounds.min_y_m, 0.2);
  EXPECT_EQ(summary.bounds.max_y_m, 0.7);
  EXPECT_EQ(summary.colors.size(), 1u);
  EXPECT_EQ(summary.marks, std::vector<std::string>{"m"});
  EXPECT_EQ(summary.files, std::set<std::string>{"a.png"});
  EXPECT_EQ(summary.sha256, sha256_hex(text));
}

TEST(Summary, OfALogWithoutTouchesHasNoBounds) {
  const TemporaryFolder folder;
  auto reader = Reader::open(folder.write("a.jsonl", kHeaderLine), {});
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE(summarize(**reader)->bounds.empty());
}

}  // namespace
}  // namespace pentimento::log
