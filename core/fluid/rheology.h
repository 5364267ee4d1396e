#pragma once
// Rheology: how stiff and how viscous paint is, from its pigment per volume (R3, R12, R13). Both
// fluid schemes use it. Pure functions; no state.

#include <span>
#include <vector>

#include "core/canvas/canvas_state.h"
#include "core/model/model.h"

namespace pentimento {

/// theta = sum P / d in 1/m (R3). Pigment without medium (d = 0) gives infinity, bare canvas gives
/// 0 (A3). `amount` >= 0 without unit, `depth_m` >= 0.
float pigment_per_volume(float amount, float depth_m);

/// The constants of R12 and R13, from Table 1. alpha < beta.
struct Rheology {
  float alpha_per_m = 4;
  float beta_per_m = 16;
  float nu_min_m2_s = 1e-6f;
  float nu_max_m2_s = 1e-2f;

  /// Phi in [0,1] (R12): 0 up to alpha, 1 from beta on, 3t^2 - 2t^3 between them. Infinity gives 1.
  float stiffness(float theta_per_m) const;
  /// nu in m^2/s (R13): linear from nu_min at alpha to nu_max at beta, constant outside.
  float viscosity_m2_s(float theta_per_m) const;
};

/// The constants for a model; gamma < zeta.
Rheology make_rheology(const Model& model);

/// Writes into out[0 .. end - begin) the total amount of pigment in the cells [begin, end) of row
/// y: the sum over layers and channels of amount[c] P.
void total_amount_row(const CanvasState& state, const std::vector<float>& amount, int y, int begin,
                      int end, std::span<float> out);

/// Rheology of a row of cells.
///   mobility_frac = 1 - Phi(theta), 0 in films thinner than dry_film_m (R15: no gravity there);
///   viscosity_m2_s = nu(theta); theta = amount / depth
/// Scheme: pointwise, exact. Stable: nothing evolves. Source: R3, R12, R13, R15 (Stuyck et al.
/// 2016, sections 5.2, 5.3 and 8.1). Departures: none. All spans have one length.
void rheology_row(const Rheology& rheology, float dry_film_m, std::span<const float> depth_m,
                  std::span<const float> amount, std::span<float> mobility_frac,
                  std::span<float> viscosity_m2_s);

}  // namespace pentimento
