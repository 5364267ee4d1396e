#pragma once
// The constants of one step of the paper scheme.

#include "core/fluid/scheme.h"

namespace pentimento::paper {

/// Films thinner than this count as bare paper, amounts smaller than this as no pigment. 1 nm is
/// the size of a molecule. Without the limit, the tails of bilinear interpolation would only widen
/// the area to compute.
inline constexpr float kNoFilm_m = 1e-9f;
inline constexpr float kNoPigment = 1e-9f;

/// An amount of pigment, or none.
inline float without_tail(float pigment) {
  return pigment < kNoPigment ? 0.0f : pigment;
}

struct StepConstants {
  float dt_s, dx_m, dy_m;
  float gravity_x_m_s2, gravity_y_m_s2;
  float gravity_z_m_s2;  // never negative (A13)
  float dry_film_m;      // thinner films feel no gravity (R15)
  float max_medium_m;
  float threshold_m_s;  // R14
  float speed_cap_m_s;  // 0 = off
  float residue;        // R19
  bool phi_scales_lateral;
};

inline StepConstants make_step_constants(const CanvasGeometry& geometry, const StepInput& in) {
  const Model& m = in.model;
  return {in.dt_s,           geometry.dx_m(),   geometry.dy_m(),
          in.gravity_m_s2.x, in.gravity_m_s2.y, in.gravity_m_s2.z > 0 ? in.gravity_m_s2.z : 0.0f,
          m.dry_film_m(),    m.max_medium_m,    m.velocity_threshold_m_s,
          m.speed_cap_m_s,   m.pigment_residue, m.phi_scales_lateral};
}

}  // namespace pentimento::paper
