#include "formats/checkpoint/canvas_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/hdf5/state_dump.h"

namespace pentimento::checkpoint {
namespace {

const GuideShape kShape = {{5, 4, 0.5, 0.4}, 2, 3, 3};

CanvasState some_state() {
  CanvasState state = make_canvas_state(kShape.geometry, kShape.layers, kShape.channels, 3, 0.9f);
  state.step = 12;
  state.depth_m(2, 1) = 0.001f;
  state.depth_m(4, 3) = 0.002f;
  state.velocity_x_m_s(0, 0) = -0.25f;
  state.velocity_y_m_s(1, 2) = -0.0f;
  state.base_m.fill(1e-5f);
  state.reflectance[1].set(3, 3, 0.1f);
  state.paper.set(2, 2, 1e-5f, 0.5e-5f);
  state.channel(1, 2)(0, 3) = 0.5f;
  state.stroke(4, 0) = 77;
  state.sleep = {1, 0, 0, 9.81f, 0};
  return state;
}

std::string bytes_of(const CanvasState& state) {
  ArchiveWriter to;
  put_canvas(state, to);
  return to.take();
}

TEST(CanvasPart, BringsBackEveryBit) {
  const CanvasState state = some_state();
  const std::string bytes = bytes_of(state);
  ArchiveReader from(bytes);
  CanvasState back = take_canvas(kShape, from);
  ASSERT_TRUE(from.complete()) << from.problem();
  back.paper = state.paper.clone();  // comes from the log
  EXPECT_EQ(state_sha256(back), state_sha256(state));
  EXPECT_EQ(back.step, 12);
  EXPECT_EQ(back.sleep, state.sleep);
  EXPECT_TRUE(std::signbit(back.velocity_y_m_s(1, 2)));
}

TEST(CanvasPart, AnEmptyPlaneTakesAlmostNothing) {
  const GuideShape wide = {{1000, 10, 1, 1}, 1, 1, 1};
  ArchiveWriter to;
  put_canvas(make_canvas_state(wide.geometry, 1, 1, 1, 0.9f), to);
  EXPECT_LT(to.bytes().size(), 1000u);  // two numbers of 4 bytes a row, in 7 planes
}

TEST(CanvasPart, RefusesAnotherCanvas) {
  const std::string bytes = bytes_of(some_state());
  for (const GuideShape& other :
       {GuideShape{{4, 5, 0.5, 0.4}, 2, 3, 3}, GuideShape{{5, 4, 0.5, 0.4}, 1, 3, 3},
        GuideShape{{5, 4, 0.5, 0.4}, 2, 4, 3}}) {
    ArchiveReader from(bytes);
    take_canvas(other, from);
    EXPECT_EQ(from.problem(), "it is of another canvas");
  }
}

TEST(CanvasPart, RefusesWhatNoCanvasHolds) {
  const auto problem_with = [](const auto& change) {
    CanvasState state = some_state();
    change(state);
    const std::string bytes = bytes_of(state);
    ArchiveReader from(bytes);
    take_canvas(kShape, from);
    return from.problem();
  };
  constexpr float kHuge = 3e38f;
  EXPECT_NE(problem_with([](CanvasState& s) { s.depth_m(1, 1) = -1e-9f; }), "");
  EXPECT_NE(problem_with([](CanvasState& s) { s.depth_m(1, 1) = kHuge; }), "");
  EXPECT_NE(problem_with([](CanvasState& s) { s.velocity_x_m_s(1, 1) = -kHuge; }), "");
  EXPECT_NE(problem_with([](CanvasState& s) { s.pigment[0](1, 1) = std::nanf(""); }), "");
  for (const float value : {-0.1f, kHuge, std::nanf("")}) {
    EXPECT_NE(problem_with([&](CanvasState& s) { s.reflectance[2].set(1, 1, value); }), "");
    EXPECT_NE(problem_with([&](CanvasState& s) { s.reflectance[2].fill(value); }), "");
  }
  EXPECT_NE(problem_with([](CanvasState& s) { s.step = -1; }), "");
  EXPECT_EQ(problem_with([](CanvasState&) {}), "");
}

TEST(CanvasPart, CutAnywhereIsRefused) {
  const std::string bytes = bytes_of(some_state());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ArchiveReader from(std::string_view(bytes).substr(0, size));
    take_canvas(kShape, from);
    EXPECT_FALSE(from.complete()) << size;
  }
}

}  // namespace
}  // namespace pentimento::checkpoint
