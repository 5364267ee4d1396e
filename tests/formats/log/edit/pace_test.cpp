#include "formats/log/edit/pace.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(Speed, DividesAllTimes) {
  EXPECT_EQ(edited<Speed>({at(1, Dry{}), touch(3, kDown)}, 2.0),
            lines_of({at(0.5, Dry{}), touch(1.5, kDown)}));
  EXPECT_EQ(edited<Speed>({at(1, Dry{})}, 0.5), lines_of({at(2, Dry{})}));
}

std::vector<std::string> without_idle(const std::vector<Event>& events) {
  return edited<DropIdle>(events, std::int64_t{2'000'000});
}

TEST(DropIdle, CutsTheTimeInWhichNobodyPaints) {
  EXPECT_EQ(without_idle({touch(1, kDown), touch(2, kUp), touch(12, kDown), touch(13, kUp),
                          touch(14, kDown), touch(15, kUp)}),
            lines_of({touch(1, kDown), touch(2, kUp), touch(4, kDown), touch(5, kUp),
                      touch(6, kDown), touch(7, kUp)}));
}

TEST(DropIdle, AHandThatRestsOnTheCanvasIsNotIdle) {
  const std::vector<Event> events = {touch(1, kDown), touch(20, kMove), touch(40, kUp)};
  EXPECT_EQ(without_idle(events), lines_of(events));
}

TEST(DropIdle, KeepsTheLastReadingOfASensor) {
  const auto gravity = [](double time_s, double x) { return at(time_s, Gravity{x, 0, 9}); };
  EXPECT_EQ(without_idle({touch(0, kDown), touch(1, kUp), gravity(2, 1), gravity(5, 2),
                          gravity(8, 3), touch(10, kDown), gravity(10.5, 4), touch(11, kUp)}),
            lines_of({touch(0, kDown), touch(1, kUp), gravity(2, 1), gravity(3, 3), touch(3, kDown),
                      gravity(3.5, 4), touch(4, kUp)}));
}

}  // namespace
}  // namespace pentimento::log
