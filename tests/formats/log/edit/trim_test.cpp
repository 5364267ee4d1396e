#include "formats/log/edit/trim.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

using Lines = std::vector<std::string>;
constexpr std::int64_t kSecond = 1'000'000;

Lines part(const std::vector<Event>& events, std::int64_t from_s, std::int64_t to_s) {
  return edited<Trim>(events, from_s * kSecond, to_s * kSecond);
}

TEST(Trim, SetsAtTheBeginningWhatHadBeenSet) {
  const Lines kept = part({at(0, Slider{"size", 0.1}), at(1, BrushChange{"flat"}),
                           at(2, Slider{"size", 0.2}), at(3, Gravity{0, 9.81, 0}), at(7, Dry{})},
                          5, 9);
  EXPECT_EQ(kept, lines_of({at(0, BrushChange{"flat"}), at(0, Slider{"size", 0.2}),
                            at(0, Gravity{0, 9.81, 0}), at(2, Dry{})}));
}

TEST(Trim, StrokesThatCrossItsEndsBeginAndEndThere) {
  const std::vector<Event> events = {
      touch(1, kDown, 0.1), touch(2, kMove, 0.2), touch(3, kMove, 0.3), touch(4, kUp, 0.4),
      touch(5, kDown, 0.5), touch(6, kMove, 0.6), touch(8, kUp, 0.8)};
  EXPECT_EQ(part(events, 2, 7),
            lines_of({touch(0, kDown, 0.2), touch(1, kMove, 0.3), touch(2, kUp, 0.4),
                      touch(3, kDown, 0.5), touch(4, kMove, 0.6), touch(5, kUp, 0.6)}));
  // Of the first stroke only its end would be left.
  EXPECT_EQ(part(events, 4, 5), lines_of({touch(1, kDown, 0.5), touch(1, kUp, 0.5)}));
}

TEST(Trim, UndoesOnlyWhatItKeeps) {
  const std::vector<Event> events = {at(1, Dry{}),  at(2, Undo{}), at(3, Clear{}),
                                     at(4, Undo{}), at(5, Undo{}), at(6, Redo{})};
  EXPECT_EQ(part(events, 3, 9), lines_of({at(0, Clear{}), at(1, Undo{}), at(3, Redo{})}));
  EXPECT_EQ(part(events, 4, 9), Lines{});
}

TEST(Trim, TheWholeIsTheLog) {
  const std::vector<Event> events = {at(0, Slider{"size", 0.1}), touch(1, kDown), touch(2, kCancel),
                                     at(3, Undo{}), at(4, Mark{"m"})};
  // A cancelled stroke is none: its undo has nothing to act on, and goes.
  EXPECT_EQ(part(events, 0, 9), lines_of({events[0], events[1], events[2], events[4]}));
}

}  // namespace
}  // namespace pentimento::log
