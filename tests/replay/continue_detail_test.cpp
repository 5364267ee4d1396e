// A detail canvas that is dumped to a file and read goes on as if nothing had happened.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <string>

#include "core/detail/store/detail_source.h"
#include "formats/hdf5/state_dump.h"
#include "replay/play/changed_canvas.h"
#include "replay/play/copies.h"
#include "replay/play/lighting_track.h"
#include "tests/core/detail/painted.h"
#include "tests/core/three_pigments.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Painted;

constexpr int kWidth = 64;

/// The detail canvas of `from`, written and read.
StateDump through_a_file(Painted& from) {
  const test::Scratch scratch;
  from.follower().finish_stamps();
  StateDump dump;
  dump.state = clone_state(from.sim().state());
  dump.detail = from.follower().canvas().layout().factor();
  dump.fine = std::make_shared<DetailSource>(from.follower().canvas(), from.sim().state());
  dump.checkpoint = from.follower().checkpoint();
  dump.model = from.sim().model();
  dump.palette = test::three_pigments();
  dump.basis = from.sim().basis();
  dump.lighting = default_lighting();
  const auto written = write_state(scratch.path("a.h5"), dump, {});
  EXPECT_TRUE(written) << written.error().message;
  Result<StateDump> back = read_state(scratch.path("a.h5"));
  EXPECT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->checkpoint == dump.checkpoint);
  return std::move(*back);  // its file stays open
}

std::string hash_of(Painted& painted) {
  painted.follower().finish_stamps();
  return detail_sha256(DetailSource(painted.follower().canvas(), painted.sim().state()));
}

int waiting_cells(const DetailCheckpoint& checkpoint) {
  int count = 0;
  for (const std::uint32_t word : checkpoint.waiting) count += std::popcount(word);
  return count;
}

class ContinueDetail : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Factors, ContinueDetail, testing::Values(2, 4));

TEST_P(ContinueDetail, APaintingGoesOnBitForBit) {
  Painted whole(kWidth, GetParam()), rest(kWidth, GetParam());
  whole.cross_and_dry();
  whole.stroke(2, 0.03, 0.1, 0.17, 0.05);
  const StateDump dump = through_a_file(whole);
  // Otherwise this test would say nothing.
  EXPECT_GT(waiting_cells(*dump.checkpoint), 0);
  EXPECT_FALSE(dump.checkpoint->stamped.empty());
  rest.go_on_from(whole, clone_state(dump.state), *dump.fine, *dump.checkpoint);
  EXPECT_EQ(hash_of(rest), hash_of(whole));
  EXPECT_TRUE(rest.follower().checkpoint() == whole.follower().checkpoint());
  for (Painted* p : {&whole, &rest}) {
    p->stroke(0, 0.05, 0.03, 0.12, 0.13);
    p->sim().set_gravity({3, 4, 8});
    for (int i = 0; i < 40; ++i) p->sim().step();
    p->sim().dry();
    p->stroke(1, 0.15, 0.03, 0.05, 0.1);
  }
  EXPECT_EQ(state_sha256(rest.sim().state()), state_sha256(whole.sim().state()));
  EXPECT_EQ(hash_of(rest), hash_of(whole));
  EXPECT_TRUE(rest.follower().checkpoint() == whole.follower().checkpoint());
}

TEST(ContinueDetailOther, WhatWaitsForTheLockIsDumpedToo) {
  Painted whole(kWidth, 3), rest(kWidth, 3);
  whole.cross();
  whole.stamp_once(0.1, 0.07);  // no step after it
  const StateDump dump = through_a_file(whole);
  rest.go_on_from(whole, clone_state(dump.state), *dump.fine, *dump.checkpoint);
  EXPECT_TRUE(rest.follower().checkpoint() == whole.follower().checkpoint());
}

TEST(ContinueDetailOther, AColourMoreLeavesTheOthersAsTheyWere) {
  Painted whole(kWidth, 2);
  whole.cross();
  const StateDump dump = through_a_file(whole);
  std::vector<Pigment> more = dump.palette;
  more.push_back(*find_library_pigment("Hansa Yellow"));
  const ChannelBasis basis = make_channels(more);
  ASSERT_EQ(basis.channels(), 4);
  const auto fine = change_channels(dump.fine, dump.basis, basis);
  ASSERT_EQ(fine->channels(), 4);
  std::vector<float> old(static_cast<std::size_t>(kWidth * 2)), now(old.size());
  for (int y = 0; y < fine->geometry().height; y += 7)
    for (int layer = 0; layer < fine->layers(); ++layer)
      for (int c = 0; c < 4; ++c) {
        std::fill(old.begin(), old.end(), 0.0f);
        if (c < 3) dump.fine->read(pigment_plane(layer, c), 0, y, old);
        fine->read(pigment_plane(layer, c), 0, y, now);
        ASSERT_EQ(now, old);
      }
  const DetailCheckpoint checkpoint = change_channels(*dump.checkpoint, dump, basis);
  const DetailLayout layout(dump.state.geometry, 2);
  ASSERT_EQ(checkpoint.tile.size(),
            static_cast<std::size_t>(layout.tiles() * (kCheckpointPigment + 2 * 4)));
  EXPECT_EQ(checkpoint.tile[kCheckpointMade], 1u);
  EXPECT_EQ(checkpoint.tile[kCheckpointPigment + 2], dump.checkpoint->tile[kCheckpointPigment + 2]);
  EXPECT_EQ(checkpoint.tile[kCheckpointPigment + 3], 0u);
  EXPECT_EQ(checkpoint.tile[kCheckpointPigment + 4], dump.checkpoint->tile[kCheckpointPigment + 3]);
}

}  // namespace
}  // namespace pentimento
