#include "core/fluid/conservative/tiles/assign_strokes.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

class AssignStrokesTest : public ::testing::Test {
 protected:
  CanvasState state_ = make_canvas_state({6, 4, 1, 1}, 2, 1, 3, 0.9f);
  const std::vector<conservative::Run> runs_ = {{0, 0, 6}, {1, 0, 6}, {2, 0, 6}, {3, 0, 6}};
  void claim(int threads = 1) { conservative::assign_strokes(state_, runs_, Threads(threads)); }
};

TEST_F(AssignStrokesTest, PaintThatRanThereIsTheLatestStrokesAround) {
  state_.stroke(1, 1) = 3;
  state_.stroke(2, 2) = 5;
  state_.depth_m(2, 1) = 1e-4f;
  claim();
  EXPECT_EQ(state_.stroke(2, 1), 5u);
}

TEST_F(AssignStrokesTest, DryCellsAndThoseOfAStrokeStayAsTheyAre) {
  state_.stroke(1, 1) = 3;
  state_.stroke(1, 2) = 1;
  state_.depth_m(1, 2) = 1e-4f;
  claim();
  EXPECT_EQ(state_.stroke(2, 1), 0u);  // dry
  EXPECT_EQ(state_.stroke(1, 2), 1u);  // touched before
}

TEST_F(AssignStrokesTest, OneCellFartherAtATimeWhateverTheOrder) {
  state_.stroke(0, 1) = 3;
  for (int x = 1; x < 6; ++x) state_.depth_m(x, 1) = 1e-4f;
  claim(2);
  EXPECT_EQ(state_.stroke(1, 1), 3u);
  EXPECT_EQ(state_.stroke(2, 1), 0u);
  claim(2);
  EXPECT_EQ(state_.stroke(2, 1), 3u);
}

}  // namespace
}  // namespace pentimento
