#pragma once
// Runs a scheme on an exact solution and measures how far it ends from it.

#include <functional>
#include <memory>
#include <vector>

#include "core/simulation/make_scheme.h"
#include "tests/core/fluid/shallow_water.h"

namespace pentimento {

struct AnalyticCase {
  double width_m, height_m;  // of the canvas
  double deepest_m;          // for the scale of depths and the wave speed sqrt(g deepest)
  double end_s;
  std::function<double(double, double)> base_m;
  std::function<shallow_water::Flow(double, double, double)> flow;  // x, y, t
};

inline AnalyticCase dam_break_case(double right_m) {
  const shallow_water::DamBreak dam(0.005, right_m);
  return {10,
          0.4,
          0.005,
          6,
          [](double, double) { return 0.0; },
          [dam](double x, double, double t) { return dam.at(x - 5, t > 0 ? t : 1e-9); }};
}
inline AnalyticCase thacker_case(bool planar) {
  const double omega = planar ? shallow_water::kPlanarOmega : shallow_water::kRadialOmega;
  return {4,
          4,
          0.1,
          2 * 3.14159265358979 / omega,
          shallow_water::bowl_m,
          planar ? shallow_water::thacker_planar : shallow_water::thacker_radial};
}

/// A fluid that the exact solutions hold for: no viscosity, friction, thresholds, caps, sleep.
inline Model ideal_fluid(double deepest_m) {
  Model m;
  m.nu_min_m2_s = 0;
  m.nu_max_m2_s = 0;
  m.friction_viscosity_floor_m2_s = 0;
  m.bed_friction = 0;
  m.gravity_cutoff_frac = 0;
  m.velocity_threshold_m_s = 0;
  m.speed_cap_m_s = 0;
  m.front_depth_m = 0;
  m.surface_tension_N_m = 0;
  m.max_medium_m = static_cast<float>(4 * deepest_m);
  m.sleep_tile_m = 1e6f;
  return m;
}

/// Sum |d - exact| / sum exact at the end. `cells` along x; square cells; steps of
/// courant dx / sqrt(g deepest), the last one fitted. `on_faces`: velocities live on right and
/// lower faces, else at centres.
inline double relative_l1(const AnalyticCase& c, SchemeKind kind, int cells, double courant) {
  const double dx = c.width_m / cells;
  const int rows = static_cast<int>(c.height_m / dx + 0.5);
  const CanvasGeometry g{cells, rows, c.width_m, rows * dx};
  CanvasState s = make_canvas_state(g, 1, 1, 3, 1.0f);
  const double shift = kind == SchemeKind::kConservative ? 0.5 : 0.0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < cells; ++x) {
      const double px = (x + 0.5) * dx, py = (y + 0.5) * dx;
      s.base_m(x, y) = static_cast<float>(c.base_m(px, py));
      s.depth_m(x, y) = static_cast<float>(c.flow(px, py, 0).depth_m);
      if (x + 1 < cells)
        s.velocity_x_m_s(x, y) = static_cast<float>(c.flow(px + shift * dx, py, 0).u_m_s);
      if (y + 1 < rows)
        s.velocity_y_m_s(x, y) = static_cast<float>(c.flow(px, py + shift * dx, 0).v_m_s);
    }
  const double step_s = courant * dx / std::sqrt(shallow_water::kG * c.deepest_m);
  const int steps = static_cast<int>(c.end_s / step_s + 0.5);
  const Model model = ideal_fluid(c.deepest_m);
  const BrushContact contact = make_brush_contact(cells, rows);
  const std::vector<float> amount{1.0f};
  const Threads threads;
  const auto scheme = make_scheme(kind, g, 1, 1);
  for (int k = 0; k < steps; ++k, ++s.step)
    scheme->step(
        s, {model, {0, 0, 9.81f}, static_cast<float>(c.end_s / steps), contact, amount, threads});
  double error = 0, whole = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < cells; ++x) {
      const double exact = c.flow((x + 0.5) * dx, (y + 0.5) * dx, c.end_s).depth_m;
      error += std::abs(static_cast<double>(s.depth_m(x, y)) - exact);
      whole += exact;
    }
  return error / whole;
}

}  // namespace pentimento
