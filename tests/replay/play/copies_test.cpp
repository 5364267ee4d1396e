#include "replay/play/copies.h"

#include <gtest/gtest.h>

#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

StateDump copied(const StateDump& dump) {
  StateDump copy;
  copy.state = clone_state(dump.state);
  copy.lighting = clone_lighting(dump.lighting);
  copy.model = dump.model;
  copy.palette = dump.palette;
  copy.basis = dump.basis;
  return copy;
}

StateDump other_light() {
  StateDump dump = test::made_up_dump(31, 17, 2, 2);
  dump.lighting.roughness_dry = 0.33f;
  dump.lighting.refractive_index = 1.4f;
  dump.lighting.relief_scale = 2;
  return dump;
}

TEST(Copies, AreEqualInEveryByteOfADump) {
  // A dump's file holds all there is to know; HDF5 itself adds nothing that changes.
  const test::Scratch scratch;
  const StateDump dump = other_light();
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  StateDump copy = copied(dump);
  copy.steps_per_second = dump.steps_per_second;
  copy.time_s = dump.time_s;
  copy.log_sha256 = dump.log_sha256;
  ASSERT_TRUE(write_state(scratch.path("b.h5"), copy, {}));
  EXPECT_TRUE(test::slurp(scratch.path("a.h5")) == test::slurp(scratch.path("b.h5")));
  EXPECT_EQ(copy.state.sleep, dump.state.sleep);
  EXPECT_EQ(copy.state.bands, 3);
}

}  // namespace
}  // namespace pentimento
