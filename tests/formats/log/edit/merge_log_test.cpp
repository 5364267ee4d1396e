#include "formats/log/edit/merge_log.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

MergeLog::OtherEvents from(std::vector<Event> events) {
  return [events = std::move(events), next = std::size_t{0}]() mutable -> std::optional<Event> {
    if (next == events.size()) return {};
    return events[next++];
  };
}
std::vector<std::string> merged(const std::vector<Event>& first, const std::vector<Event>& other) {
  return edited<MergeLog>(first, Header(), Header(), from(other));
}
/// The ids that touches get.
std::int64_t left(std::int64_t id = 0) {
  return 2 * id;
}
std::int64_t right(std::int64_t id = 0) {
  return 2 * id + 1;
}

TEST(MergeLog, KeepsTheTimesOfHandsThatPaintAlike) {
  EXPECT_EQ(merged({touch(1, kDown, 0.1), touch(3, kUp, 0.2)},
                   {touch(2, kDown, 0.5), touch(4, kUp, 0.6), at(9, Dry{})}),
            lines_of({touch(1, kDown, 0.1, left()), touch(2, kDown, 0.5, right()),
                      touch(3, kUp, 0.2, left()), touch(4, kUp, 0.6, right()), at(9, Dry{})}));
}

TEST(MergeLog, EachHandPaintsWithItsOwn) {
  EXPECT_EQ(
      merged({at(0, BrushChange{"flat"}), touch(1, kDown), touch(2, kUp), touch(5, kDown),
              touch(6, kUp)},
             {at(0, Slider{"size", 0.1}), touch(3, kDown), touch(4, kUp)}),
      lines_of({at(0, BrushChange{"flat"}), at(0, Slider{"size", 0.1}), at(1, Slider{"size", 0.03}),
                touch(1, kDown, 0, left()), touch(2, kUp, 0, left()), at(3, BrushChange{"round"}),
                at(3, Slider{"size", 0.1}), touch(3, kDown, 0, right()), touch(4, kUp, 0, right()),
                at(5, BrushChange{"flat"}), at(5, Slider{"size", 0.03}), touch(5, kDown, 0, left()),
                touch(6, kUp, 0, left())}));
}

// The other hand would paint with another brush while the first is down: it waits, and goes on with
// its pauses as they were.
TEST(MergeLog, TheOtherHandWaitsForTheFirst) {
  EXPECT_EQ(
      merged({touch(1, kDown), touch(3, kMove), touch(4, kUp), touch(20, kDown), touch(21, kUp)},
             {at(0, BrushChange{"flat"}), touch(2, kDown), touch(3, kUp), touch(5, kDown),
              touch(6, kUp)}),
      lines_of({at(0, BrushChange{"flat"}), at(1, BrushChange{"round"}), touch(1, kDown, 0, left()),
                touch(3, kMove, 0, left()), touch(4, kUp, 0, left()), at(4, BrushChange{"flat"}),
                touch(4, kDown, 0, right()), touch(5, kUp, 0, right()), touch(7, kDown, 0, right()),
                touch(8, kUp, 0, right()), at(20, BrushChange{"round"}),
                touch(20, kDown, 0, left()), touch(21, kUp, 0, left())}));
}

TEST(MergeLog, TheFirstHandWaitsForTheOther) {
  EXPECT_EQ(
      merged({touch(2, kDown), touch(3, kUp), touch(9, kDown), touch(10, kUp)},
             {at(0, BrushChange{"flat"}), touch(1, kDown), touch(6, kUp)}),
      lines_of({at(0, BrushChange{"flat"}), touch(1, kDown, 0, right()), touch(6, kUp, 0, right()),
                at(6, BrushChange{"round"}), touch(6, kDown, 0, left()), touch(7, kUp, 0, left()),
                touch(13, kDown, 0, left()), touch(14, kUp, 0, left())}));
}

// Both paint alike until one changes its brush: that holds from its next stroke on.
TEST(MergeLog, AChangeWhileBothAreDownWaits) {
  EXPECT_EQ(
      merged({touch(1, kDown), touch(5, kUp)}, {touch(2, kDown), at(3, BrushChange{"flat"}),
                                                touch(4, kUp), touch(6, kDown), touch(7, kUp)}),
      lines_of({touch(1, kDown, 0, left()), touch(2, kDown, 0, right()), touch(4, kUp, 0, right()),
                touch(5, kUp, 0, left()), at(6, BrushChange{"flat"}), touch(6, kDown, 0, right()),
                touch(7, kUp, 0, right())}));
}

TEST(MergeLog, TheRoomIsTheFirstLogs) {
  EXPECT_EQ(
      merged({at(1, Gravity{1, 0, 9})}, {at(0, Gravity{2, 0, 9}), at(0, Light{}), at(2, Dry{})}),
      lines_of({at(1, Gravity{1, 0, 9}), at(2, Dry{})}));
}

TEST(MergeLog, AnEmptyLogChangesNothing) {
  const std::vector<Event> events = {at(1, Dry{}), at(2, Clear{})};
  EXPECT_EQ(merged(events, {}), lines_of(events));
  EXPECT_EQ(merged({}, events), lines_of(events));
  // A stroke that never ends keeps nobody waiting.
  EXPECT_EQ(merged({touch(1, kDown)}, {at(0, BrushChange{"flat"}), touch(2, kDown), touch(3, kUp)})
                .size(),
            6u);
}

}  // namespace
}  // namespace pentimento::log
