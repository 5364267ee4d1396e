// A step that leaves out bare cells comes to the same bits as one that computes all awake cells.

#include <gtest/gtest.h>

#include <memory>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

/// Cells of 1 mm by 1.25 mm with a weave; two layers of two channels; four pools of runny paint
/// with bare canvas between them.
Basin pools() {
  Basin b({192, 128, 0.192, 0.16}, 2, 2, 2);
  b.model.sleep_tile_m = 0.064f;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 192; ++x) {
      b.state.base_m(x, y) = 2e-4f * static_cast<float>((x / 2 + y / 3) % 3);
      const bool wet = x % 96 > 20 && x % 96 < 60 && y % 64 > 5 && y % 64 < 20;
      if (!wet) continue;
      b.state.depth_m(x, y) = 0x1p-26f * static_cast<float>(200000 + 900 * ((x * 7 + y * 5) % 11));
      for (int k = 0; k < 2; ++k) b.state.channel(k, (x / 8) % 2)(x, y) = 0x1p-10f;
    }
  b.gravity_m_s2 = {3, 8, 4};
  return b;
}

/// What happens to the canvas before step `step`.
void happen(Basin& b, int step) {
  // The brush pushes paint further than a step carries it, at the edge of a pool.
  if (step % 9 == 4)
    for (int y = 10; y < 18; ++y)
      for (int x = 50; x < 62; ++x) {
        b.contact.weight(x, y) = 1;
        b.contact.push_x_m(x, y) = 1.0f;
        b.contact.push_y_m(x, y) = -0.002f;
        b.contact.touch(x, x + 1, y, y + 1);
      }
  // It lifts a pool that moves: what is bare then has a velocity still.
  if (step == 20)
    for (int y = 0; y < 64; ++y)
      for (int x = 96; x < 192; ++x) {
        b.state.depth_m(x, y) = 0;
        for (Field<float>& plane : b.state.pigment) plane(x, y) = 0;
      }
  // Paint comes where there was none.
  if (step == 25)
    for (int y = 4; y < 12; ++y)
      for (int x = 150; x < 170; ++x) b.state.depth_m(x, y) = 0x1p-8f;
  // Gusts along x and along y, so that steps are cut into parts and cells go far.
  if (step % 8 == 7)
    for (int y = 0; y < 127; ++y)
      for (int x = 0; x < 191; ++x) {
        const bool along_x = step % 16 == 7;
        if (!(b.state.depth_m(x, y) > 0)) continue;
        if (!(b.state.depth_m(along_x ? x + 1 : x, along_x ? y : y + 1) > 0)) continue;
        (along_x ? b.state.velocity_x_m_s : b.state.velocity_y_m_s)(x, y) = 1.0f;
      }
  b.gravity_m_s2.x = step % 40 < 20 ? 3.0f : -3.0f;
}

void expect_same(const CanvasState& a, const CanvasState& b, int step) {
  EXPECT_TRUE(same_bits(a.depth_m, b.depth_m)) << step;
  EXPECT_TRUE(same_bits(a.velocity_x_m_s, b.velocity_x_m_s)) << step;
  EXPECT_TRUE(same_bits(a.velocity_y_m_s, b.velocity_y_m_s)) << step;
  for (std::size_t k = 0; k < a.pigment.size(); ++k)
    EXPECT_TRUE(same_bits(a.pigment[k], b.pigment[k])) << step << " " << k;
  EXPECT_EQ(a.sleep, b.sleep) << step;
}

TEST(WetStep, HasTheBitsOfAStepThatLeavesNothingOut) {
  Basin wet = pools(), all = pools();
  all.scheme.leave_nothing_out();
  for (int step = 0; step < 80; ++step) {
    for (Basin* b : {&wet, &all}) {
      happen(*b, step);
      b->step();
    }
    ASSERT_NO_FATAL_FAILURE(expect_same(wet.state, all.state, step));
    if (HasFailure()) return;
  }
  EXPECT_GT(highest(wet.state.velocity_y_m_s), 0.01f) << "it still runs";
}

TEST(WetStep, OfASchemeThatKnowsNothingOfTheStepBeforeHasThem) {
  Basin going_on = pools();
  for (int step = 0; step < 40; ++step) {
    Basin resumed = pools();
    for (Field<float> CanvasState::*plane :
         {&CanvasState::depth_m, &CanvasState::velocity_x_m_s, &CanvasState::velocity_y_m_s})
      resumed.state.*plane = (going_on.state.*plane).clone();
    for (std::size_t k = 0; k < going_on.state.pigment.size(); ++k)
      resumed.state.pigment[k] = going_on.state.pigment[k].clone();
    resumed.state.sleep = going_on.state.sleep;
    resumed.state.step = going_on.state.step;
    for (Basin* b : {&going_on, &resumed}) {
      happen(*b, step);
      b->step();
    }
    expect_same(going_on.state, resumed.state, step);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace pentimento::conservative
