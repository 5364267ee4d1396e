#include "formats/log/edit/as_spline.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(AsSpline, DropsWhatTheCurveDoesNotNeed) {
  EXPECT_EQ(edited<AsSpline>({at(0, Dry{}), touch(1, kDown, 0.1), touch(2, kMove, 0.2),
                              touch(3, kMove, 0.3), touch(4, kUp, 0.4), at(5, Clear{})},
                             SplineTolerance()),
            lines_of({at(0, Dry{}), touch(1, kDown, 0.1), touch(4, kUp, 0.4), at(5, Clear{})}));
}

TEST(AsSpline, SamplesBesideOtherEventsStay) {
  EXPECT_EQ(
      edited<AsSpline>(
          {touch(0.01, kDown, 0.1), touch(0.02, kMove, 0.2), at(0.025, Slider{"size", 0.1}),
           touch(0.03, kMove, 0.3), touch(0.04, kMove, 0.4), touch(0.05, kUp, 0.5)},
          SplineTolerance()),
      lines_of({touch(0.01, kDown, 0.1), touch(0.02, kMove, 0.2), at(0.025, Slider{"size", 0.1}),
                touch(0.03, kMove, 0.3), touch(0.05, kUp, 0.5)}));
}

TEST(AsSpline, TouchesAtOnceAreFittedEachForItself) {
  EXPECT_EQ(
      edited<AsSpline>({touch(1, kDown, 0.1, 0), touch(2, kDown, 0.8, 1), touch(3, kMove, 0.2, 0),
                        touch(3, kMove, 0.5, 1), touch(4, kMove, 0.1, 1), touch(5, kUp, 0.3, 0),
                        touch(6, kUp, 0.05, 1)},
                       SplineTolerance()),
      lines_of({touch(1, kDown, 0.1, 0), touch(2, kDown, 0.8, 1), touch(3, kMove, 0.5, 1),
                touch(4, kMove, 0.1, 1), touch(5, kUp, 0.3, 0), touch(6, kUp, 0.05, 1)}));
}

TEST(AsSpline, AStrokeThatNeverEndsIsKept) {
  const std::vector<Event> open = {touch(1, kDown, 0.1), touch(2, kMove, 0.2),
                                   touch(3, kMove, 0.3)};
  EXPECT_EQ(edited<AsSpline>(open, SplineTolerance()), lines_of(open));
}

}  // namespace
}  // namespace pentimento::log
