#include "core/optics/composite.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/approx.h"
#include "core/base/check.h"

namespace pentimento {
namespace {

/// One band of one film over `ground`; Kx, Sx >= 0. The factor exp(-z) keeps cosh from overflowing;
/// the series' next term is below a float's rounding for z < 0.25.
float film_over(float Kx, float Sx, float ground) {
  const float z = std::sqrt(Kx * (Kx + 2 * Sx));
  const float e = approx::exp(-z);
  const float t = z * z;
  const float w = z < 0.25f ? e * (1 + t / 6 * (1 + t / 20)) : (1 - e * e) / (2 * z);
  const float d = 0.5f * (1 + e * e) + (Kx + Sx) * w;
  const float R = Sx * w / d, T = e / d;
  return R + T * T * ground / std::max(1 - R * ground, 1e-7f);
}

/// The factor on K c and S c of each layer of the cell; 0 for an empty layer.
using LayerFactors = std::array<float, kMaxLayers>;
LayerFactors layer_factors(const CompositeOptics& o, const CanvasState& s, int x, int y) {
  LayerFactors factor{};
  int occupied = 0;
  for (int k = 0; k < s.layers; ++k) {
    float amount = 0;
    for (int c = 0; c < s.channels; ++c) amount += o.amount(c) * s.channel(k, c)(x, y);
    if (amount > kEmptyLayerAmount) {
      factor[static_cast<std::size_t>(k)] = amount;
      ++occupied;
    }
  }
  const float film = occupied == 0 ? 0 : s.depth_m(x, y) / static_cast<float>(occupied);
  for (float& f : factor) {
    if (f == 0) continue;
    f = o.thickness == OpticalThickness::kAmount ? o.per_reference : film * o.per_reference / f;
  }
  return factor;
}

float composite_cell(const CompositeOptics& o, const CanvasState& s, const LayerFactors& factor,
                     int band, int x, int y) {
  float reflectance = s.reflectance[static_cast<std::size_t>(band)](x, y);
  for (int k = 0; k < s.layers; ++k) {
    const float f = factor[static_cast<std::size_t>(k)];
    if (f == 0) continue;
    float K = 0, S = 0;
    for (int c = 0; c < s.channels; ++c) {
      const float amount = s.channel(k, c)(x, y);
      K += o.K(band, c) * amount;
      S += o.S(band, c) * amount;
    }
    reflectance = film_over(std::max(K * f, 0.0f), std::max(S * f, 0.0f), reflectance);
  }
  return std::clamp(reflectance, 0.0f, 1.0f);
}

}  // namespace

CompositeOptics make_composite_optics(const ChannelBasis& basis, const Model& model) {
  const bool by_amount = model.optical_thickness == OpticalThickness::kAmount;
  return {basis.K.cast<float>(),
          basis.S.cast<float>(),
          basis.amount,
          model.optical_thickness,
          1 / (by_amount ? model.pigment_reference : model.depth_reference_m),
          model.saunderson_k2};
}

void composite_row(const CompositeOptics& optics, const CanvasState& state, int y,
                   std::span<const float> coverage, std::span<float* const> reflectance) {
  PENTIMENTO_CHECK(coverage.empty() || static_cast<int>(coverage.size()) == state.geometry.width);
  PENTIMENTO_CHECK(state.layers <= kMaxLayers && optics.K.cols() == state.channels);
  PENTIMENTO_CHECK(static_cast<int>(reflectance.size()) == state.bands);
  for (int x = 0; x < state.geometry.width; ++x) {
    LayerFactors factor = layer_factors(optics, state, x, y);
    const float covered = coverage.empty() ? 1.0f : coverage[static_cast<std::size_t>(x)];
    if (covered < 1)
      for (float& f : factor) f /= covered;
    for (int band = 0; band < state.bands; ++band) {
      const float bare = state.reflectance[static_cast<std::size_t>(band)](x, y);
      const float film = composite_cell(optics, state, factor, band, x, y);
      reflectance[static_cast<std::size_t>(band)][x] =
          covered < 1 ? partly_covered(bare, film, covered, optics.k2) : film;
    }
  }
}

}  // namespace pentimento
