#include "core/detail/flow/surface_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pentimento {
namespace {

CanvasState guide(const std::function<double(int, int)>& height) {
  CanvasState state = make_canvas_state({32, 24, 0.032, 0.024}, 1, 1, 3, 0.9f);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      state.base_m(x, y) = 0.25f * static_cast<float>(height(x, y));
      state.depth_m(x, y) = 0.75f * static_cast<float>(height(x, y));
    }
  }
  return state;
}

double block_mean(const Field<float>& fine, int x, int y, int k) {
  double sum = 0;
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) sum += static_cast<double>(fine(x * k + i, y * k + j));
  return sum / (k * k);
}

TEST(SurfaceSpline, KeepsAPlaneAndItsHeight) {
  const CanvasState state = guide([](int x, int y) { return 1e-3 * (2 + 0.1 * x + 0.05 * y); });
  const Field<float> fine = surface_spline(state, {8, 16, 8, 12}, 4);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      EXPECT_NEAR(fine(x, y),
                  1e-3 * (2 + 0.1 * (8 + (x + 0.5) / 4 - 0.5) + 0.05 * (8 + (y + 0.5) / 4 - 0.5)),
                  1e-8);
}

TEST(SurfaceSpline, HoldsAboutWhatTheGuidesCellsHold) {
  // Waves of three cells: the plain spline's means have 0.398 of their height, two rounds bring
  // them to 1 - 0.602^3 = 0.782.
  const CanvasState state =
      guide([](int x, int) { return 1e-3 * (2 + std::sin(2 * 3.14159265 * x / 3)); });
  const Field<float> fine = surface_spline(state, {6, 18, 6, 18}, 8);
  double wanted = 0, found = 0;
  for (int x = 0; x < 12; ++x) {
    const double wave = std::sin(2 * 3.14159265 * (6 + x) / 3);
    wanted += wave * wave;
    found += wave * (block_mean(fine, x, 5, 8) / 1e-3 - 2);
  }
  EXPECT_NEAR(found / wanted, 0.782, 0.01);
}

TEST(SurfaceSpline, BoxesAgreeWhereTheyMeetAlsoAtTheCanvassEdge) {
  const CanvasState state =
      guide([](int x, int y) { return 1e-3 * (1 + 0.1 * ((x * 13 + y * 7) % 11)); });
  const Field<float> whole = surface_spline(state, {0, 32, 0, 24}, 3);
  for (const CellBox& box : {CellBox{0, 5, 0, 4}, CellBox{5, 9, 10, 12}, CellBox{28, 32, 20, 24}}) {
    const Field<float> part = surface_spline(state, box, 3);
    for (int y = 0; y < part.height(); ++y)
      for (int x = 0; x < part.width(); ++x)
        EXPECT_EQ(part(x, y), whole(box.x0 * 3 + x, box.y0 * 3 + y));
  }
}

}  // namespace
}  // namespace pentimento
