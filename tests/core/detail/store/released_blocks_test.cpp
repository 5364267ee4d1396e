#include "core/detail/store/released_blocks.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

class ReleasedBlocksTest : public ::testing::Test {
 protected:
  ReleasedBlocks left_{DetailLayout({80, 60, 0.1, 0.1}, 4)};  // tiles of 32 blocks
};

TEST_F(ReleasedBlocksTest, AreThoseThatTheStepDidNotTouchAgain) {
  left_.stamped({10, 12, 5, 6}, {1, 0});
  EXPECT_TRUE(left_.step().empty());
  left_.stamped({11, 13, 5, 6}, {0, 1});
  const std::vector<ReleasedBlock> first = left_.step();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].at.x0, 10);
  EXPECT_EQ(first[0].at.y, 5);
  EXPECT_EQ(first[0].way.x, 1);
  const std::vector<ReleasedBlock> rest = left_.step();
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(rest[0].way.y, 1);  // of the last stamp
  EXPECT_TRUE(left_.step().empty());
}

TEST_F(ReleasedBlocksTest, ComeByRowsEachWithItsTile) {
  left_.stamped({31, 33, 31, 33}, {1, 0});
  left_.stamped({2, 3, 40, 41}, {1, 0});
  left_.step();
  const std::vector<ReleasedBlock> left = left_.step();
  ASSERT_EQ(left.size(), 5u);
  const int tiles[] = {0, 1, 3, 4, 3};
  for (std::size_t i = 0; i < left.size(); ++i) EXPECT_EQ(left[i].at.tile, tiles[i]) << i;
  EXPECT_EQ(left[4].at.y, 40);
}

TEST_F(ReleasedBlocksTest, AFreshCanvasHasNone) {
  left_.stamped({10, 12, 5, 6}, {1, 0});
  left_.clear();
  left_.step();
  EXPECT_TRUE(left_.step().empty());
}

TEST_F(ReleasedBlocksTest, ACellStampedBeforeAClearIsNewAfterIt) {
  left_.stamped({10, 12, 5, 6}, {1, 0});
  left_.clear();
  left_.stamped({11, 12, 5, 6}, {0, 1});
  left_.step();
  const std::vector<ReleasedBlock> left = left_.step();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].at.x0, 11);
}

TEST_F(ReleasedBlocksTest, GoOnFromWhatWasStamped) {
  // One block of the step before, one of this step.
  left_.stamped({10, 11, 5, 6}, {1, 0});
  left_.step();
  left_.stamped({20, 21, 7, 8}, {0, 1});
  ReleasedBlocks later{DetailLayout({80, 60, 0.1, 0.1}, 4)};
  later.restore(left_.stamped());
  EXPECT_EQ(later.stamped(), left_.stamped());
  for (ReleasedBlocks* blocks : {&left_, &later}) {
    const std::vector<ReleasedBlock> first = blocks->step();
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].at.x0, 10);
    const std::vector<ReleasedBlock> rest = blocks->step();
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].at.x0, 20);
    EXPECT_EQ(rest[0].way.y, 1);
  }
}

}  // namespace
}  // namespace pentimento
