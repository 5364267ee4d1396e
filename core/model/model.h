#pragma once
// The parameters of the simulation: the paper's Table 1, and the chosen readings of what the paper
// leaves open. Plain numbers in SI units, no behaviour. A log's header sets them by the names of
// these fields without the unit (docs/action-log.md has unit, range, default and reason of each).

#include "core/model/viewing.h"

namespace pentimento {

enum class SchemeKind { kPaper, kConservative };
/// Whether optical thickness follows the amount of pigment or the depth of the film (A28).
enum class OpticalThickness { kAmount, kDepth };

/// The most layers that a cell can have. Kernels keep that many on their stacks.
inline constexpr int kMaxLayers = 8;

/// Of linseed oil with a little turpentine. Only forces of a surface need it.
inline constexpr float kPaintDensity_kg_m3 = 950;

struct Model {
  SchemeKind scheme = SchemeKind::kConservative;
  int layers = 2;                        // 1..kMaxLayers
  float nu_min_m2_s = 1e-6f;             // viscosity at theta <= alpha
  float nu_max_m2_s = 1e-2f;             // viscosity at theta >= beta
  float max_pigment = 1.0f;              // full pigment slider
  float max_medium_m = 0.05f;            // deposits fill a cell no deeper
  float gamma = 0.2f;                    // alpha = gamma max_pigment / max_medium
  float zeta = 0.8f;                     // beta = zeta max_pigment / max_medium
  int jacobi_iterations = 4;             // sweeps of the `paper` scheme (R9)
  float gravity_cutoff_frac = 0.01f;     // of max_medium: thinner films feel no gravity (R15)
  float velocity_threshold_m_s = 1e-3f;  // slower paint stands (R14, A10)
  float bed_friction = 1.0f;             // times 3 nu / d^2; `conservative` only
  float friction_viscosity_floor_m2_s = 1e-3f;  // lower bound of nu in the friction; `conservative`
  float speed_cap_m_s = 1.4007f;                // 2 sqrt(g max_medium), g = 9.81; 0 = off
  float pigment_residue = 4e-4f;                // sticks to the paper for ever (R19)
  bool phi_scales_lateral = true;               // reading (a) of A7
  bool superbee = false;    // limiter of `conservative`: superbee in place of MC
  float brush_push = 0.2f;  // alpha of the stamp displacement; `conservative`

  // The rest of `conservative`; docs/numerics.md has the reason of each number.
  float layer_speed = 2.0f;        // layer speed = this times u times height in film; paper: 1
  float crowding_m_s2 = 200.0f;    // pressure of paint 20 % deeper than max_medium, per slope
  float sleep_tile_m = 1.0f / 32;  // side of a tile that sleeps or wakes as a whole
  float front_depth_m = 0.0025f;   // films less deep at the edge do not wet bare canvas; 0 = all do
  float front_reach_m = 0.004f;    // over which the depth at an edge is taken
  float surface_tension_N_m = 0.032f;  // of oil; 0 = the surface has none
  float wake_gravity_m_s2 = 0.05f;     // a change of gravity that wakes sleeping paint
  float most_cells_moved = 1.2f;       // faster paint makes a step of several parts...
  int most_parts_of_step = 8;          // ...but not of more than these
  int viscosity_cycles = 1;            // V-cycles per step and velocity component
  int height_cycles = 3;               // V-cycles per step

  // Brush and transfer (R21-R28).
  float film_medium_m = 0.002f;    // one pass deposits this at full medium slider (tip's mean)
  float film_pigment = 0.04f;      // one pass deposits this at full pigment slider
  float contact_levelling = 1.0f;  // 0 off; 1: less on bumps, more in hollows (A22)

  // Optics.
  OpticalThickness optical_thickness = OpticalThickness::kAmount;
  float pigment_reference = 0.015f;  // amount of optical thickness 1 (A29)
  float depth_reference_m = 0.001f;  // depth of optical thickness 1, for `depth`
  OpticsKind optics = OpticsKind::kRgb;
  int bands = kDefaultBands;  // of spectral optics; RGB has three
  Illuminant illuminant = Illuminant::kD65;
  Observer observer = Observer::kCie1931;
  float saunderson_k1 = 0;  // what the interface of paint and air reflects from outside...
  float saunderson_k2 = 0;  // ...and from inside

  int reflectance_bands() const { return optics == OpticsKind::kRgb ? 3 : bands; }
  Viewing viewing() const { return {illuminant, observer}; }

  /// Pigment per volume (1/m) below which paint flows freely, and above which it stands (Table 1).
  float alpha_per_m() const { return gamma * max_pigment / max_medium_m; }
  float beta_per_m() const { return zeta * max_pigment / max_medium_m; }
  /// Surface tension over the density of paint, sigma / rho. The length sqrt(s / 9.81) is 1.8 mm.
  float tension_m3_s2() const { return surface_tension_N_m / kPaintDensity_kg_m3; }
  /// Films thinner than this feel no gravity (R15).
  float dry_film_m() const { return gravity_cutoff_frac * max_medium_m; }
};

}  // namespace pentimento
