// Whatever happens, the state stays finite and the bits do not depend on threads.

#include <gtest/gtest.h>

#include "core/base/approx.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

void expect_sound(const TestCanvas& canvas, const char* when) {
  const CanvasState& s = canvas.state;
  // A rounding of h above the largest depth; brush and flow share the cap of speed here.
  EXPECT_TRUE(within(s.depth_m, 0, canvas.model.max_medium_m * 1.001f)) << when;
  EXPECT_TRUE(within(s.velocity_x_m_s, -1.5f, 1.5f)) << when;
  EXPECT_TRUE(within(s.velocity_y_m_s, -1.5f, 1.5f)) << when;
  for (const Field<float>& p : s.pigment) EXPECT_TRUE(within(p, 0, 1e6f)) << when;
}

/// A brush going round and round over a canvas, laying paint.
void paint(TestCanvas& canvas, int step) {
  clear(canvas.contact);
  const float angle = 0.2f * static_cast<float>(step);
  const int w = canvas.state.geometry.width, h = canvas.state.geometry.height;
  const int x = w / 2 + static_cast<int>(static_cast<float>(w) * 0.3f * approx::cos(angle));
  const int y = h / 2 + static_cast<int>(static_cast<float>(h) * 0.3f * approx::sin(angle));
  const int x0 = std::max(x - 4, 0), x1 = std::min(x + 4, w);
  const int y0 = std::max(y - 4, 0), y1 = std::min(y + 4, h);
  for (int j = y0; j < y1; ++j)
    for (int i = x0; i < x1; ++i) {
      canvas.state.depth_m(i, j) = std::min(canvas.state.depth_m(i, j) + 5e-4f, 0.05f);
      canvas.state.channel(step / 40 % 2, 0)(i, j) += 0.004f;
    }
  canvas.touch(x0, y0, x1, y1, -approx::sin(angle), approx::cos(angle));
}

TEST(PaperScheme, SurvivesShakingWhilePainting) {
  TestCanvas canvas(96, 72);
  canvas.roughen(6e-4f);
  for (int step = 0; step < 200; ++step) {
    paint(canvas, step);
    // 10 Hz at 45 steps per second, on all axes.
    const float swing = 20 * approx::sin(6.2831853f * 10 * static_cast<float>(step) / 45);
    canvas.gravity = {swing, -swing, 9.81f + swing};
    canvas.step();
    expect_sound(canvas, "shaking");
  }
}

TEST(PaperScheme, SurvivesEveryGravityOnAFullCanvas) {
  for (float gz : {-20.0f, -9.81f, 0.0f, 9.81f, 20.0f}) {
    TestCanvas canvas(96, 72);
    canvas.roughen(0.02f);
    canvas.flood(0.05f, 0.3f);  // theta 6
    for (int step = 0; step < 60; ++step) {
      canvas.gravity = {step < 30 ? 20.0f : -20.0f, step % 20 < 10 ? -20.0f : 20.0f, gz};
      canvas.step();
    }
    expect_sound(canvas, "full canvas");
  }
}

TEST(PaperScheme, SurvivesBumpsThatEmerge) {
  TestCanvas canvas(96, 72);
  canvas.roughen(0.03f);
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 96; ++x)
      canvas.state.depth_m(x, y) = std::max(0.015f - canvas.state.base_m(x, y), 0.0f);
  canvas.steps(200);
  expect_sound(canvas, "islands");
}

TEST(PaperScheme, SurvivesPigmentWithoutMedium) {
  TestCanvas canvas(96, 72);
  canvas.pour(20, 20, 60, 50, 0, 0.5f);
  canvas.pour(40, 30, 80, 60, 0.004f, 0.5f);
  canvas.gravity = {4, -8, 2};
  for (int step = 0; step < 100; ++step) {
    paint(canvas, step);
    canvas.step();
  }
  expect_sound(canvas, "bare pigment");
}

TEST(PaperScheme, SurvivesEverySmallCanvas) {
  for (int width = 1; width <= 40; ++width)
    for (int height : {1, 2, 5}) {
      TestCanvas canvas(width, height, 1, 1);
      canvas.flood(0.004f, 0.01f);
      canvas.state.depth_m(0, 0) = 0.02f;
      canvas.gravity = {3, -3, 9};
      canvas.touch(0, 0, (width + 1) / 2, 1, 0.5f, 0.1f);
      canvas.steps(5);
      expect_sound(canvas, "small");
    }
}

TEST(PaperScheme, SurvivesAGlitchOfTheBrush) {
  TestCanvas canvas(48, 36);
  canvas.flood(0.01f, 0.02f);
  canvas.touch(10, 10, 20, 20, 1e6f, -1e6f);
  canvas.steps(3);
  clear(canvas.contact);
  canvas.steps(3);
  expect_sound(canvas, "glitch");
}

TEST(PaperScheme, BitsDoNotDependOnThreads) {
  const auto painted = [](int threads) {
    TestCanvas canvas(96, 72, 2, 2, threads);
    canvas.roughen(6e-4f);
    canvas.gravity = {1, -4, 8};
    for (int step = 0; step < 60; ++step) {
      paint(canvas, step);
      canvas.step();
    }
    return copy_of(canvas.state);
  };
  const CanvasState one = painted(1);
  EXPECT_TRUE(same_state(one, painted(2)));
  EXPECT_TRUE(same_state(one, painted(7)));
}

TEST(PaperScheme, TheStateIsAllThatAStepKnows) {
  TestCanvas one(96, 72), other(96, 72);
  for (TestCanvas* canvas : {&one, &other}) {
    canvas->roughen(6e-4f);
    canvas->gravity = {1, -4, 8};
  }
  for (int step = 0; step < 60; ++step) {
    if (step == 30) other.state = copy_of(one.state);  // a scheme that has seen nothing so far
    paint(one, step);
    one.step();
    if (step < 30) continue;
    paint(other, step);
    other.step();
  }
  EXPECT_TRUE(same_state(one.state, other.state));
}

TEST(PaperScheme, WhatAStepLeavesAloneStaysAlone) {
  TestCanvas canvas(64, 48);
  canvas.pour(20, 20, 40, 30, 0.004f, 0.02f);
  canvas.gravity = {0.1f, -0.1f, 9.81f};
  bool changed = true;
  for (int step = 0; step < 3000 && changed; ++step) changed = canvas.step();
  EXPECT_FALSE(changed);
  const CanvasState rest = copy_of(canvas.state);
  EXPECT_FALSE(canvas.step());
  EXPECT_TRUE(same_state(canvas.state, rest));
}

}  // namespace
}  // namespace pentimento::paper
