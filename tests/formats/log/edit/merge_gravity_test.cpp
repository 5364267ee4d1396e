#include "formats/log/edit/merge_gravity.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(MergeGravity, PutsReadingsBetweenTheEventsAndLeavesOutTheLogsOwn) {
  const std::vector<Event> readings = {at(0, Gravity{1, 0, 9}), at(2, Gravity{2, 0, 9}),
                                       at(3, Gravity{3, 0, 9}), at(9, Gravity{4, 0, 9})};
  EXPECT_EQ(edited<MergeGravity>({at(1, Gravity{7, 7, 7}), at(2, Dry{}), at(4, Clear{})}, readings),
            lines_of({readings[0], readings[1], at(2, Dry{}), readings[2], at(4, Clear{})}));
}

}  // namespace
}  // namespace pentimento::log
