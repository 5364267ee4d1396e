#include "core/canvas/canvas_state.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/core/base/resident_memory.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

std::vector<float> paper_row(const CanvasState& state, int y) {
  std::vector<float> row(static_cast<std::size_t>(state.geometry.width));
  read_paper(state, 0, y, row);
  return row;
}

TEST(CanvasState, WhatDriesLeavesThePaperAsItWas) {
  CanvasState state = make_canvas_state({4, 2, 1, 1}, 1, 1, 3, 0.9f);
  const std::array<float, 4> weave = {1e-4f, 2e-4f, 0, 3e-4f};
  std::copy(weave.begin(), weave.end(), state.base_m.row(1));
  EXPECT_EQ(paper_row(state, 1), std::vector<float>(weave.begin(), weave.end()));
  write_base(state, 1, 1, std::array<float, 2>{0.7f, 0.3f});
  EXPECT_EQ(state.base_m(1, 1), 0.7f);
  EXPECT_EQ(state.base_m(3, 1), 3e-4f);
  EXPECT_EQ(paper_row(state, 1), std::vector<float>(weave.begin(), weave.end()));
  write_base(state, 0, 1, std::array<float, 2>{0.1f, 0.8f});  // once more
  EXPECT_EQ(paper_row(state, 1), std::vector<float>(weave.begin(), weave.end()));
  EXPECT_EQ(paper_row(state, 0), std::vector<float>(4, 0));
}

TEST(CanvasState, ThePaperIsSetUnderTheBase) {
  CanvasState state = make_canvas_state({4, 2, 1, 1}, 1, 1, 3, 0.9f);
  state.base_m(2, 1) = 5;
  write_paper(state, 1, 1, std::array<float, 3>{1, 2, 0});
  EXPECT_EQ(state.base_m(2, 1), 5);
  const CanvasState copy = clone_state(state);
  EXPECT_EQ(paper_row(copy, 1), (std::vector<float>{0, 1, 2, 0}));
  EXPECT_EQ(paper_relief_of(copy)(2, 1), 2);
  EXPECT_EQ(paper_relief_of(copy)(2, 0), 0);
}

TEST(CanvasState, ABareCanvasTakesNoMemory) {
  if (is_marked_when_given()) GTEST_SKIP();
  const long before_mib = resident_mib();
  // 16 planes of 256 MiB. A sanitizer's shadow of them takes an eighth.
  CanvasState state = make_canvas_state({8192, 8192, 1, 1}, 1, 7, 3, 0.9f);
  state.reflectance[2].fill(0.8f);
  EXPECT_EQ(state.reflectance[1](8000, 8000), 0.9f);
  EXPECT_EQ(state.reflectance[2](8000, 8000), 0.8f);
  EXPECT_LT(resident_mib() - before_mib, test::kStride == 1 ? 32 : 16 * 40);
}

}  // namespace
}  // namespace pentimento
