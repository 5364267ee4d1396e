#include "formats/log/edit/editing_writer.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

/// Keeps lines in place of a file.
class LineWriter : public Writer {
 public:
  explicit LineWriter(std::vector<std::string>& lines) : lines_(lines) {}
  void write(const Header& header) override {
    lines_.push_back(std::to_string(header.canvas_width_m).substr(0, 3));
  }
  void write(const Event& event) override { lines_.push_back(event_json(event)); }
  Result<Published> finish() override { return Published{"a.jsonl", "hash"}; }

 private:
  std::vector<std::string>& lines_;
};

TEST(EditingWriter, DoesAllEditsInTheirOrder) {
  std::vector<std::string> lines;
  Edits edits;
  edits.gravity = {at(0, Gravity{0, 9, 0})};
  edits.trim_us = {10'000'000, 100'000'000};
  edits.longest_idle_us = 4'000'000;
  edits.speed = 2;
  edits.resample_hz = 2;
  edits.canvas_m = {2, 1.5};
  EditingWriter writer(edits, std::make_unique<LineWriter>(lines));
  writer.write(Header());
  for (const Event& event :
       {touch(5, kDown), touch(6, kUp), touch(12, kDown, 0.1), touch(14, kMove, 0.3),
        touch(14, kUp, 0.3), touch(34, kDown, 0.4), touch(34, kUp, 0.4)})
    writer.write(event);
  const auto done = writer.finish();
  ASSERT_TRUE(done);
  EXPECT_EQ(done->file, "a.jsonl");
  // From 12 s it begins at 2 s, twice as fast at 1 s; 20 s without paint become 4 s, then 2 s.
  std::vector<std::string> expected = {"2.0"};
  const std::vector<Event> events = {at(0, Slider{"size", static_cast<double>(0.03f) * 2}),
                                     at(0, Gravity{0, 9, 0}),
                                     touch(1, kDown, 0.2),
                                     touch(1.5, kMove, 0.4),
                                     touch(2, kMove, 0.6),
                                     touch(2, kUp, 0.6),
                                     touch(4, kDown, 0.8),
                                     touch(4, kUp, 0.8)};
  for (const std::string& line : lines_of(events)) expected.push_back(line);
  EXPECT_EQ(lines, expected);
  EXPECT_EQ(writer.events(), 8);
  EXPECT_EQ(writer.last_us(), 4'000'000);
}

TEST(EditingWriter, AnExtensionGetsItsTimeAndKeepsTheRest) {
  std::vector<std::string> lines;
  Edits edits;
  edits.speed = 4;
  EditingWriter writer(edits, std::make_unique<LineWriter>(lines));
  writer.write(Header());
  writer.write(at(2, Extension{"x-a", R"({"t":2,"type":"x-a","w":[1,2.50,"\n"]})"}));
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(lines.back(), R"({"t":0.5,"type":"x-a","w":[1,2.5,"\u000a"]})");
}

}  // namespace
}  // namespace pentimento::log
