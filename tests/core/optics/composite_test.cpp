#include "core/optics/composite.h"

#include <gtest/gtest.h>

#include "core/optics/kubelka_munk.h"
#include "core/optics/paints/pigment_library.h"

namespace pentimento {
namespace {

std::vector<Pigment> some_palette() {
  return {*find_library_pigment("cadmium yellow"), *find_library_pigment("french ultramarine"),
          *find_library_pigment("titanium white")};
}

/// A row of cells with two layers, thin to thick, layer 1 empty in every third cell.
CanvasState some_state(const ChannelBasis& basis, int width) {
  CanvasState s = make_canvas_state({width, 1, 1, 1}, 2, basis.channels(), 3, 0.9f);
  for (int x = 0; x < width; ++x) {
    const float t = static_cast<float>(x) / static_cast<float>(width);
    s.depth_m(x, 0) = 0.004f * t;
    const float amount[2][3] = {{0.03f * t, 0.01f, 0.05f * (1 - t)}, {0.002f, 0.2f * t * t, 0}};
    for (int layer = 0; layer < (x % 3 == 0 ? 1 : 2); ++layer) {
      for (int c = 0; c < basis.channels(); ++c) {
        for (int p = 0; p < 3; ++p) {
          s.channel(layer, c)(x, 0) += basis.load(c, p) * amount[layer][p];
        }
      }
    }
  }
  return s;
}

std::vector<Field<float>> composed(const CanvasState& s, const ChannelBasis& basis,
                                   const Model& model) {
  std::vector<Field<float>> out;
  std::vector<float*> row;
  for (int band = 0; band < 3; ++band) {
    out.emplace_back(s.geometry.width, 1);
    row.push_back(out.back().row(0));
  }
  composite_row(make_composite_optics(basis, model), s, 0, {}, row);
  return out;
}

/// The slow twin: double precision, the definition of R31 word for word.
double expected(const CanvasState& s, const ChannelBasis& basis, const Model& m, int x, int band) {
  double R = s.reflectance[static_cast<std::size_t>(band)](x, 0);
  int occupied = 0;
  for (int layer = 0; layer < s.layers; ++layer) {
    float amount = 0;
    for (int c = 0; c < s.channels; ++c) amount += basis.amount(c) * s.channel(layer, c)(x, 0);
    occupied += amount > 0;
  }
  for (int layer = 0; layer < s.layers; ++layer) {
    double K = 0, S = 0, P = 0;
    for (int c = 0; c < s.channels; ++c) {
      const double amount = s.channel(layer, c)(x, 0);
      K += basis.K(band, c) * amount;
      S += basis.S(band, c) * amount;
      P += static_cast<double>(basis.amount(c)) * amount;
    }
    if (P == 0) continue;
    const double film_m = static_cast<double>(s.depth_m(x, 0)) / occupied;
    const double f = m.optical_thickness == OpticalThickness::kAmount
                         ? 1 / static_cast<double>(m.pigment_reference)
                         : film_m / static_cast<double>(m.depth_reference_m) / P;
    R = km_over(km_film({K * f, S * f}, 1), R);
  }
  return R;
}

// 2e-6: a few float roundings of a reflectance below 1.
constexpr double kFloatTolerance = 2e-6;

TEST(CompositeRow, EqualsTheDefinitionForAmountAndDepth) {
  const ChannelBasis basis = palette_channels(some_palette());
  for (const auto thickness : {OpticalThickness::kAmount, OpticalThickness::kDepth}) {
    Model model;
    model.optical_thickness = thickness;
    const CanvasState s = some_state(basis, 64);
    const std::vector<Field<float>> R = composed(s, basis, model);
    for (int x = 0; x < 64; ++x) {
      for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(R[static_cast<std::size_t>(band)](x, 0), expected(s, basis, model, x, band),
                    kFloatTolerance);
      }
    }
  }
}

TEST(CompositeRow, PaletteAndOpticalChannelsAgree) {
  const Model model;
  const ChannelBasis palette = palette_channels(some_palette());
  const ChannelBasis optical = optical_channels(some_palette());
  const auto a = composed(some_state(palette, 64), palette, model);
  const auto b = composed(some_state(optical, 64), optical, model);
  for (std::size_t band = 0; band < 3; ++band) {
    for (int x = 0; x < 64; ++x) EXPECT_NEAR(a[band](x, 0), b[band](x, 0), kFloatTolerance);
  }
}

TEST(CompositeRow, LeavesUnpaintedCellsUntouched) {
  const ChannelBasis basis = palette_channels(some_palette());
  CanvasState s = make_canvas_state({8, 1, 1, 1}, 2, 3, 3, 0.123456789f);
  const auto R = composed(s, basis, Model{});
  for (int x = 0; x < 8; ++x) EXPECT_EQ(R[1](x, 0), 0.123456789f);
}

// Half a cell of paint twice as thick beside half a bare cell: the eye sees the mean of their
// light, each through its own interface.
TEST(CompositeRow, WherePaintCoversHalfACellTheLightIsTheMeanOfBoth) {
  const ChannelBasis basis = palette_channels(some_palette());
  Model model;
  model.saunderson_k1 = 0.03f;
  model.saunderson_k2 = 0.6f;
  CanvasState s = some_state(basis, 64), thick = some_state(basis, 64);
  for (Field<float>& plane : thick.pigment)
    for (int x = 0; x < 64; ++x) plane(x, 0) *= 2;
  const auto film = composed(thick, basis, model);
  const std::vector<float> half(64, 0.5f);
  std::vector<std::vector<float>> half_covered(3, std::vector<float>(64));
  std::vector<float*> rows;
  for (std::vector<float>& row : half_covered) rows.push_back(row.data());
  const auto seen = [&](float R) { return saunderson_seen(static_cast<double>(R), 0.03, 0.6); };
  const double bare = seen(s.reflectance[0](0, 0));
  composite_row(make_composite_optics(basis, model), s, 0, half, rows);
  for (std::size_t band = 0; band < 3; ++band)
    for (int x = 0; x < 64; ++x)
      EXPECT_NEAR(seen(half_covered[band][static_cast<std::size_t>(x)]),
                  (bare + seen(film[band](x, 0))) / 2,
                  4 * kFloatTolerance);  // Saunderson's slope is at most 1 / (1 - k2)
}

TEST(CompositeRow, ThinnedPaintIsTransparentByAmountAndOpaqueByDepth) {
  const ChannelBasis basis = palette_channels(some_palette());
  Model by_amount, by_depth;
  by_depth.optical_thickness = OpticalThickness::kDepth;
  CanvasState s = make_canvas_state({1, 1, 1, 1}, 1, 3, 3, 0.9f);
  s.depth_m(0, 0) = 0.01f;
  s.channel(0, 1)(0, 0) = 1e-4f;  // a trace of blue in much oil
  EXPECT_GT(composed(s, basis, by_amount)[0](0, 0), 0.88f);
  EXPECT_LT(composed(s, basis, by_depth)[0](0, 0), 0.1f);
}

TEST(CompositeRow, StaysInRangeForExtremeAmounts) {
  const ChannelBasis basis = palette_channels(some_palette());
  CanvasState s = make_canvas_state({6, 1, 1, 1}, 2, 3, 3, 1.0f);
  const float amounts[] = {0, 1e-30f, 1e-6f, 1, 1e6f, 1e12f};
  for (int x = 0; x < 6; ++x) s.channel(1, x % 3)(x, 0) = amounts[x];
  const auto R = composed(s, basis, Model{});
  for (const Field<float>& band : R) {
    for (int x = 0; x < 6; ++x) EXPECT_TRUE(band(x, 0) >= 0 && band(x, 0) <= 1) << x;
  }
}

}  // namespace
}  // namespace pentimento
