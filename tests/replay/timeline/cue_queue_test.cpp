#include "replay/timeline/cue_queue.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

PendingCue cue(std::int64_t time_us, std::int64_t place, std::int64_t line) {
  return {{time_us, line, 0, StrokeEnd{0}}, place, 0};
}

TEST(CueQueue, GoesByTimeThenByPlaceInTheLogThenByArrival) {
  CueQueue queue;
  queue.push(cue(20, 1, 5));
  queue.push(cue(10, 3, 3));
  queue.push(cue(10, 2, 1));
  queue.push(cue(10, 2, 2));  // of the same event, after it
  queue.push(cue(10, 3, 4));
  std::vector<std::int64_t> lines;
  while (!queue.empty()) {
    EXPECT_EQ(queue.front().cue.line, static_cast<std::int64_t>(lines.size()) + 1);
    lines.push_back(queue.pop().cue.line);
  }
  EXPECT_EQ(lines, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
}

TEST(CueQueue, ManyOfOneMomentComeInTheirOrder) {
  CueQueue queue;
  for (int i = 0; i < 1000; ++i) queue.push(cue(7, 7, i));
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(queue.pop().cue.line, i);
}

}  // namespace
}  // namespace pentimento
