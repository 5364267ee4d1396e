#include "core/fluid/rheology.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/kernel.h"

namespace pentimento {

namespace {

/// Where theta stands between alpha and beta, in [0,1]; infinity gives 1.
float between(const Rheology& r, float theta_per_m) {
  const float t = (theta_per_m - r.alpha_per_m) / (r.beta_per_m - r.alpha_per_m);
  return std::min(std::max(t, 0.0f), 1.0f);
}

PENTIMENTO_KERNEL
void add_share_row(float share, const float* __restrict pigment, std::size_t count,
                   float* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] += share * pigment[i];
}

// Four planes of pigment, and their shares of the amount.
struct FourPlanes {
  std::array<const float*, 4> pigment;
  std::array<float, 4> share;
};

// The same for one plane after the other, with `out` read and written once.
PENTIMENTO_KERNEL
void add_four_shares_row(const FourPlanes& planes, std::size_t count, float* __restrict out) {
  const float* __restrict a = planes.pigment[0];
  const float* __restrict b = planes.pigment[1];
  const float* __restrict c = planes.pigment[2];
  const float* __restrict d = planes.pigment[3];
  const auto [share_a, share_b, share_c, share_d] = planes.share;
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < count; ++i)
    out[i] = (((out[i] + share_a * a[i]) + share_b * b[i]) + share_c * c[i]) + share_d * d[i];
}

float smooth_step(float t) {
  return t * t * (3.0f - 2.0f * t);
}

float mixed_viscosity(const Rheology& r, float t) {
  return r.nu_min_m2_s + t * (r.nu_max_m2_s - r.nu_min_m2_s);
}

}  // namespace

float pigment_per_volume(float amount, float depth_m) {
  const float bare = amount > 0.0f ? std::numeric_limits<float>::infinity() : 0.0f;
  return depth_m > 0.0f ? amount / depth_m : bare;
}

float Rheology::stiffness(float theta_per_m) const {
  return smooth_step(between(*this, theta_per_m));
}

float Rheology::viscosity_m2_s(float theta_per_m) const {
  return mixed_viscosity(*this, between(*this, theta_per_m));
}

Rheology make_rheology(const Model& model) {
  return {model.alpha_per_m(), model.beta_per_m(), model.nu_min_m2_s, model.nu_max_m2_s};
}

void total_amount_row(const CanvasState& state, const std::vector<float>& amount, int y, int begin,
                      int end, std::span<float> out) {
  const auto count = static_cast<std::size_t>(end - begin);
  std::fill_n(out.begin(), count, 0.0f);
  FourPlanes waiting{};
  std::size_t planes = 0;
  for (int layer = 0; layer < state.layers; ++layer)
    for (int c = 0; c < state.channels; ++c) {
      const float share = amount[static_cast<std::size_t>(c)];
      if (share == 0.0f) continue;
      waiting.pigment[planes] = state.channel(layer, c).row(y) + begin;
      waiting.share[planes] = share;
      if (++planes < waiting.share.size()) continue;
      add_four_shares_row(waiting, count, out.data());
      planes = 0;
    }
  for (std::size_t k = 0; k < planes; ++k)
    add_share_row(waiting.share[k], waiting.pigment[k], count, out.data());
}

namespace {

PENTIMENTO_KERNEL
void rheology_cells(const Rheology& rheology, float dry_film_m, const float* __restrict depth_m,
                    const float* __restrict amount, std::size_t n, float* __restrict mobility_frac,
                    float* __restrict viscosity_m2_s) {
  const Rheology r = rheology;
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float bare = amount[i] > 0.0f ? std::numeric_limits<float>::infinity() : 0.0f;
    const bool wet = depth_m[i] > 0.0f;
    const float ratio = amount[i] / (wet ? depth_m[i] : 1.0f);
    const float theta = wet ? ratio : bare;
    const float linear = (theta - r.alpha_per_m) / (r.beta_per_m - r.alpha_per_m);
    const float least = linear > 0.0f ? linear : 0.0f;
    const float t = least < 1.0f ? least : 1.0f;
    const float mobility = 1.0f - t * t * (3.0f - 2.0f * t);
    mobility_frac[i] = depth_m[i] < dry_film_m ? 0.0f : mobility;
    viscosity_m2_s[i] = r.nu_min_m2_s + t * (r.nu_max_m2_s - r.nu_min_m2_s);
  }
}

}  // namespace

void rheology_row(const Rheology& rheology, float dry_film_m, std::span<const float> depth_m,
                  std::span<const float> amount, std::span<float> mobility_frac,
                  std::span<float> viscosity_m2_s) {
  rheology_cells(rheology, dry_film_m, depth_m.data(), amount.data(), depth_m.size(),
                 mobility_frac.data(), viscosity_m2_s.data());
}

}  // namespace pentimento
