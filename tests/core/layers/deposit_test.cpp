#include "core/layers/deposit.h"

#include <gtest/gtest.h>

#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

TEST(Deposit, AddsToTheOpenedLayerAndSetsTheId) {
  LayerCells cells(2, 2);
  cells.set(0, {0.5f, 0});
  cells.state().stroke(0, 0) = 3;
  std::vector<float> paint = {0.25f, 0.125f, 0.0625f, 0};
  std::vector<double> sums(3);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.5f, 0.125f}));
  EXPECT_EQ(cells.get(1), (std::vector<float>{0, 0.0625f}));
  EXPECT_EQ(cells.state().depth_m(0, 0), 0.25f);
  EXPECT_EQ(cells.state().stroke(0, 0), 4u);
  EXPECT_EQ(sums, (std::vector<double>{0.25, 0.125, 0.0625}));
}

TEST(Deposit, WhatDoesNotFitStaysInTheBrushWithItsPigment) {
  LayerCells cells(2, 1);
  cells.state().depth_m(0, 0) = 0.75f;
  std::vector<float> paint = {0.5f, 0.5f, 0, 0};
  std::vector<double> sums(2);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.state().depth_m(0, 0), 1.0f);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.25f, 0}));
  EXPECT_EQ(paint[0], 0.25f);
}

TEST(Deposit, NothingLaidChangesNothing) {
  LayerCells cells(2, 1);
  cells.set(0, {0.5f, 0.25f});
  cells.state().stroke(0, 0) = 3;
  std::vector<float> paint(4, 0.0f);
  std::vector<double> sums(2);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.5f, 0.25f}));
  EXPECT_EQ(cells.state().stroke(0, 0), 3u);
}

}  // namespace
}  // namespace pentimento
