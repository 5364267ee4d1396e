#include "formats/log/edit/resample.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(Resample, PutsSamplesAtEvenTimesOnTheLinesBetween) {
  EXPECT_EQ(
      edited<Resample>(
          {touch(1, kDown, 0), touch(1.5, kMove, 1), touch(2, kMove, 3), touch(2, kUp, 3)}, 4.0),
      lines_of({touch(1, kDown, 0), touch(1.25, kMove, 0.5), touch(1.5, kMove, 1),
                touch(1.75, kMove, 2), touch(2, kMove, 3), touch(2, kUp, 3)}));
  // Fewer than there were: beginning and end stay.
  EXPECT_EQ(edited<Resample>({touch(1, kDown, 0), touch(1.1, kMove, 1), touch(1.2, kUp, 2)}, 1.0),
            lines_of({touch(1, kDown, 0), touch(1.2, kUp, 2)}));
}

TEST(Resample, KeepsTheOrderOfTimesOfTouchesAndOthers) {
  EXPECT_EQ(edited<Resample>({touch(0, kDown, 0, 1), touch(0.1, kDown, 5, 2), at(0.25, Undo{}),
                              touch(1, kUp, 4, 1), touch(1.1, kUp, 7, 2)},
                             2.0),
            lines_of({touch(0, kDown, 0, 1), touch(0.1, kDown, 5, 2), at(0.25, Undo{}),
                      touch(0.5, kMove, 2, 1), touch(0.6, kMove, 6, 2), touch(1, kUp, 4, 1),
                      touch(1.1, kUp, 7, 2)}));
}

TEST(Resample, AllThatBothSamplesHaveIsBetweenThem) {
  Touch a, b;
  a.pressure = 0.2;
  b.pressure = 0.6;
  a.tilt_x_deg = -10;
  b.tilt_x_deg = 30;
  a.twist_deg = 5;
  b.radius_m = 0.1;
  b.y_m = 2;
  const Touch half = between(a, b, 0.5);
  EXPECT_DOUBLE_EQ(*half.pressure, 0.4);
  EXPECT_DOUBLE_EQ(*half.tilt_x_deg, 10);
  EXPECT_DOUBLE_EQ(half.y_m, 1);
  EXPECT_FALSE(half.twist_deg || half.radius_m || half.tilt_y_deg);
}

}  // namespace
}  // namespace pentimento::log
