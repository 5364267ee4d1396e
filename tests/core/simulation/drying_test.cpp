#include "core/simulation/drying.h"

#include <gtest/gtest.h>

#include "core/optics/composite.h"
#include "core/optics/paints/pigment_library.h"

namespace pentimento {
namespace {

constexpr int kWidth = 21;
/// Rows of the canvas: nothing, medium alone in one cell, paint without medium in one, and both in
/// the last cell, where a search by vectors ends.
enum Row : int { kBare, kMedium, kPigment, kPaint, kBelow, kRows };

struct Canvas {
  Canvas() : basis(make_channels({*find_library_pigment("french ultramarine")})) {
    state = make_canvas_state({kWidth, kRows, 0.21, 0.05}, 1, basis.channels(), 3, 0.8f);
    state.base_m.fill(0.0003f);
    state.depth_m(3, kMedium) = 0.001f;
    state.depth_m(kWidth - 1, kPaint) = 0.002f;
    for (int c = 0; c < basis.channels(); ++c) {
      state.channel(0, c)(5, kPigment) = 0.01f * basis.load(c, 0);
      state.channel(0, c)(kWidth - 1, kPaint) = 0.02f * basis.load(c, 0);
    }
  }
  float reflectance(int x, int y) const { return state.reflectance[0](x, y); }

  ChannelBasis basis;
  Model model;
  CanvasState state;
};

/// Each row by the definition, as if all of them were wet.
std::vector<Field<float>> composed(const Canvas& canvas) {
  std::vector<Field<float>> out;
  for (int band = 0; band < 3; ++band) out.emplace_back(kWidth, kRows);
  for (int y = 0; y < kRows; ++y) {
    std::vector<float*> row;
    for (Field<float>& band : out) row.push_back(band.row(y));
    composite_row(make_composite_optics(canvas.basis, canvas.model), canvas.state, y, {}, row);
  }
  return out;
}

TEST(Drying, FixesWhatIsThereAndLeavesBareRowsAsTheyAre) {
  Canvas canvas;
  const std::vector<Field<float>> expected = composed(canvas);
  PaintFlow dried;
  dried.channel.assign(static_cast<std::size_t>(canvas.basis.channels()), 0.0);
  dry_canvas(canvas.state, canvas.basis, canvas.model, EdgeCells::kCovered, Threads(1), dried);
  for (int band = 0; band < 3; ++band)
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kWidth; ++x)
        EXPECT_EQ(canvas.state.reflectance[static_cast<std::size_t>(band)](x, y),
                  expected[static_cast<std::size_t>(band)](x, y))
            << band << " " << x << " " << y;
  EXPECT_EQ(canvas.reflectance(0, kBare), 0.8f);
  EXPECT_LT(canvas.reflectance(5, kPigment), 0.7f);
  EXPECT_LT(canvas.reflectance(kWidth - 1, kPaint), 0.7f);
  EXPECT_EQ(canvas.state.base_m(0, kBare), 0.0003f);
  EXPECT_EQ(canvas.state.base_m(3, kMedium), 0.0003f + 0.001f);
  EXPECT_EQ(canvas.state.base_m(kWidth - 1, kPaint), 0.0003f + 0.002f);
}

TEST(Drying, TakesAllThatIsWet) {
  Canvas canvas;
  PaintFlow dried;
  dried.channel.assign(static_cast<std::size_t>(canvas.basis.channels()), 0.0);
  dry_canvas(canvas.state, canvas.basis, canvas.model, EdgeCells::kPartlyCovered, Threads(2),
             dried);
  EXPECT_NEAR(dried.medium_m3, 0.003 * 1e-4, 1e-12);  // cells of a square centimetre
  const PaintFlow wet = wet_paint(canvas.state);
  EXPECT_EQ(wet.medium_m3, 0);
  for (const double amount : wet.channel) EXPECT_EQ(amount, 0);
}

}  // namespace
}  // namespace pentimento
