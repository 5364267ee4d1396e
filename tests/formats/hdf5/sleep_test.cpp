#include "formats/hdf5/sleep.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using namespace conservative;

/// A dump of which every tile has values of its own, gravity pointing up and down the canvas.
StateDump asleep() {
  StateDump dump = test::made_up_dump(61, 47, 2, 3);
  std::vector<float>& sleep = dump.state.sleep;
  for (std::size_t i = 0; i < sleep.size(); i += kSleepValues) {
    const auto tile = static_cast<float>(i / kSleepValues);
    sleep[i + kAsleep] = i % 2 == 0 ? 1.0f : 0.0f;
    sleep[i + kGravityX] = 0.5f + tile;
    sleep[i + kGravityY] = i % 3 == 0 ? 2.25f + tile : -2.25f - tile;  // y down
    sleep[i + kGravityZ] = 9.0f - tile;
    sleep[i + kFeelsGravity] = i % 2 == 0 ? 0.0f : 1.0f;
  }
  return dump;
}

TEST(Sleep, OtherProgramsReadGravityWithYUpAsALogHasIt) {
  const test::Scratch scratch;
  const StateDump dump = asleep();
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  test::spill(scratch.path("read.py"), R"(
import sys, h5py
for row in h5py.File(sys.argv[1], 'r')['/fluid/asleep']: print(*('%g' % v for v in row))
)");
  std::string promised;  // by docs/state-format.md: 1 = asleep; right, up, out; 1 = feels gravity
  const std::vector<float>& sleep = dump.state.sleep;
  for (std::size_t i = 0; i < sleep.size(); i += kSleepValues)
    promised += fmt::format("{:g} {:g} {:g} {:g} {:g}\n", sleep[i + kAsleep], sleep[i + kGravityX],
                            -sleep[i + kGravityY], sleep[i + kGravityZ], sleep[i + kFeelsGravity]);
  const auto [status, text] =
      test::run("/usr/bin/python3 " + scratch.path("read.py") + " " + scratch.path("a.h5"));
  EXPECT_EQ(status, 0);
  EXPECT_EQ(text, promised);
}

TEST(Sleep, ComesBackAsItWas) {
  const test::Scratch scratch;
  const StateDump dump = asleep();
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->state.sleep, dump.state.sleep);
}

}  // namespace
}  // namespace pentimento
