#include "core/fluid/conservative/conservative_scheme.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/fetch_ahead.h"
#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/face_row.h"
#include "core/fluid/conservative/contact_line.h"
#include "core/fluid/conservative/solve/capillary_row.h"
#include "core/fluid/conservative/solve/find_drag.h"
#include "core/fluid/conservative/solve/force_in_box.h"
#include "core/fluid/conservative/solve/force_row.h"
#include "core/fluid/conservative/solve/height_row.h"
#include "core/fluid/conservative/solve/viscous_row.h"
#include "core/fluid/conservative/tiles/assign_strokes.h"
#include "core/fluid/conservative/tiles/round_to_quanta.h"
#include "core/fluid/rheology.h"

namespace pentimento::conservative {
namespace {

constexpr float kCrowdedFrac = 0.2f;  // of max_medium: the depth over which crowding rises

// The stiffest coupling that the tension may have, dt^2 K d s L^2 (capillary_row.h): what a few
// V-cycles leave of it must be small against the surface itself. With 2000, waves of the grid grow
// on films of a centimetre. On long cells the cycles do less: with 100 they grow on cells of 1
// by 2.
float stiffest(float dx_m, float dy_m) {
  constexpr float kOfSquareCells = 600;
  const float ratio = dx_m < dy_m ? dx_m / dy_m : dy_m / dx_m;
  return kOfSquareCells * ratio * ratio * ratio;
}

/// The deepest puddle that surface tension alone carries: 2 sqrt(sigma / (rho g)).
float carried_by_tension(const Model& model) {
  constexpr float kGravity_m_s2 = 9.81f;
  const float tension = model.tension_m3_s2();
  return tension > 0 ? 2 * std::sqrt(tension / kGravity_m_s2) : 1.0f;
}

/// Gravity under which a heap on an upright or hanging canvas spreads: that along the canvas, and
/// twice that off it, so that a drop hangs half as deep again as its surface carries.
float sagging_gravity(const Vec3f& g) {
  const float off = g.z < 0 ? 2 * g.z : 0.0f;
  return std::sqrt(g.x * g.x + g.y * g.y + off * off);
}

constexpr float kLeastFilm_m = 5e-5f;  // thinner paint follows the weave: it has no surface

float cap_of(const Model& model) {
  return model.speed_cap_m_s > 0 ? model.speed_cap_m_s : 1e9f;  // 0 = off
}

// Into how many parts a step is cut, so that no paint comes further than most_cells_moved in one
// part.
int parts_of_step(const Model& model, float travel_cells) {
  int parts = 1;
  while (parts < model.most_parts_of_step &&
         travel_cells > model.most_cells_moved * static_cast<float>(parts))
    ++parts;
  return parts;
}

float positive(float x) {
  return x > 0 ? x : 0.0f;
}

PENTIMENTO_KERNEL
void height_row(const float* __restrict base, const float* __restrict depth, int n,
                float* __restrict height) {
  for (int i = 0; i < n; ++i) height[i] = base[i] + depth[i];
}

// Writes zeros, where there is anything else: a plane takes no memory where nobody writes to it.
void forget(float* begin, float* end) {
  const auto is_some = [](float v) { return std::bit_cast<std::uint32_t>(v) != 0; };
  if (std::any_of(begin, end, is_some)) std::fill(begin, end, 0.0f);
}

FaceRow faces_at(NodePlanes& n, int x, int y) {
  return {n.depth_m.row(y) + x, n.mobility_frac.row(y) + x, n.viscosity_m2_s.row(y) + x,
          n.friction_frac.row(y) + x};
}

// Asks for the cells of a run in planes that a pass writes, some rows ahead.
void fetch(std::initializer_list<const WorkPlane*> planes, const Run& r) {
  for (const WorkPlane* plane : planes) fetch_row_ahead(*plane, r.y, r.x0, r.x1);
}

// Calls body(x, n) for the faces of run `r` that paint may cross: the right faces between its
// cells, or the lower faces above awake cells.
template <typename Body>
void for_open_faces(const SleepTiles& tiles, Axis axis, const Run& r, const Body& body) {
  if (axis == Axis::kX) {
    if (r.size() > 1) body(r.x0, r.size() - 1);
  } else {
    tiles.for_open_below(r, [&](int x0, int x1) { body(x0, x1 - x0); });
  }
}

}  // namespace

ConservativeScheme::ConservativeScheme(const CanvasGeometry& geometry)
    : geometry_(geometry), work_(geometry) {}

void ConservativeScheme::make_tiles(float sleep_tile_m) {
  sleep_tile_m_ = sleep_tile_m;
  tiles_ = std::make_unique<SleepTiles>(geometry_, sleep_tile_m);
  live_ = {};
  resting_ = {};
  knows_before_ = false;
}

bool ConservativeScheme::step(CanvasState& state, const StepInput& in) {
  if (!tiles_) make_tiles(in.model.sleep_tile_m);
  report_.begin();
  // 1. Wake tiles: finds the tiles that may change in this step, and the cells of them that it
  // computes.
  tiles_->wake(state, in);
  const int parts = parts_of_step(in.model, tiles_->travel_cells());
  find_wet(state, in, tiles_->travel_cells() / static_cast<float>(parts));
  // A fresh canvas rests, but for what the brush has just touched: planes take no memory where
  // nobody writes to them.
  if (state.sleep.empty() && in.fresh) tiles_->rest_fresh(state, in);
  if (tiles_->awake_tiles().empty()) {
    work_.solver.set_runs({});
    give_back();
    return false;
  }
  passed("wake");

  // 2. Round to quanta: rounds what the brush left, so that all sums of this step are exact.
  round_to_quanta(state, in);
  passed("round");
  // 3. to 7. once for each part: no front crosses more cells than its face depths are good for.
  for (int part = 0; part < parts; ++part) {
    const BrushContact& contact = part == 0 ? in.contact : untouched_;  // the push acts once
    const float dt_s = in.dt_s / static_cast<float>(parts);
    part_of_step(
        state,
        {in.model, in.gravity_m_s2, dt_s, contact, in.amount, in.threads, in.listener, in.fresh},
        part);
  }
  // 8. Tiles fall asleep: finds the tiles that came to rest.
  tiles_->fall_asleep(state, in, [&](const CellBox& b) { return feels_gravity(work_, b); });
  passed("sleep");
  // 9. Account: maxima for the reports. It changes nothing of the state.
  report_.add(state, wet_.runs(), tiles_->awake_share(), in.threads);
  passed("account");
  give_back();
  return true;
}

// The workspace of tiles that slept through this step holds zeros, which need no memory.
void ConservativeScheme::give_back() {
  if (!PlaneMemory::leaves_out(geometry_.width, geometry_.height)) return;
  for (const CellBox& box : resting_.find(*tiles_)) work_.give_back(box);
}

void ConservativeScheme::part_of_step(CanvasState& state, const StepInput& in, int part) {
  if (part > 0) find_wet(state, in, travel_cells(state, wet_.runs(), in.dt_s));
  // 3. Advection: carries paint and momentum with the velocity that the state holds. The axes take
  // turns in being the first, so that neither is favoured.
  advect(state, in, (state.step + part) % 2 == 0);
  // 4. Rheology and faces: finds how the paint that arrived resists motion, ...
  for_runs(in.threads, wet_.runs(), [&](const Run& r) { find_rheology(state, in, r); });
  passed("rheology");
  // ... brings that to the faces, where the velocities live, ...
  for_runs(in.threads, wet_.runs(), [&](const Run& r) { find_faces(state, in, r); });
  passed("faces");
  // ... and holds the films that are too shallow to advance over bare canvas.
  pin_edges(state, in);
  passed("edges");
  // 4d. ... and finds how far a force gets where the paint beside it drags, too.
  find_drag(state.geometry, in.dt_s, RunIndex(wet_.runs(), geometry_.height), in.threads, work_);
  passed("drag");
  // Where nothing moves and nothing gives way, that is all.
  if (part == 0) find_live(in);
  live_runs_ = live_.live_of(wet_.runs(), *tiles_);
  work_.solver.set_runs(live_runs_);
  if (live_runs_.empty()) return;
  // Elsewhere it foresees where the surface comes to if all goes on as it moves.
  for_runs(in.threads, live_runs_, [&](const Run& r) { foresee_surface(state, in, r); });
  copy_sleeping_neighbours(state);
  passed("surface");
  // 5. Viscosity: evens out the velocity inside each film.
  apply_viscosity(state, in);
  passed("viscosity");
  // 6. Gravity and bed friction, 7. Height: accelerates the paint, then finds the height that the
  // velocities lead to, and the velocities that this height leaves.
  solve_height(state, in);
  passed("height");
}

void ConservativeScheme::advect(CanvasState& state, const StepInput& in, bool even) {
  // Each axis is one sweep. The second sweep takes what the first one left.
  const Axis first = even ? Axis::kX : Axis::kY;
  const Axis second = even ? Axis::kY : Axis::kX;
  if (tiles_->moves()) {
    // 3a. Masses: how much paint lies around each face before anything moves.
    fill_node_masses(state, wet_, in.threads, work_);
    passed("masses");
    for (const Axis axis : {first, second}) {
      // 3b. Momentum: mass and velocity around each face. The velocities of the state stay, for the
      // paint needs them.
      advect_momentum(state, in, axis, axis == first ? Turn::kFirst : Turn::kSecond, wet_, work_);
      passed(axis == Axis::kX ? "momentum_x" : "momentum_y");
    }
  } else {
    rest_nodes(in.threads);
    passed("rest");
  }
  for (const Axis axis : {first, second}) {
    // 3c. Paint: depth and every channel of every layer, over the same edges.
    advect_paint(state, in, axis, wet_);
    passed(axis == Axis::kX ? "paint_x" : "paint_y");
  }
  // 3d. Stroke ids: paint that ran onto bare canvas belongs to the stroke that it came from.
  assign_strokes(state, wet_.runs(), in.threads);
  // The listener repeats this motion on its own canvas.
  if (in.listener == nullptr) return;
  in.listener->edges().x_first = even;
  in.listener->moved(state, in, wet_.runs());
}

// 3a, 3b where nothing moves: there is no momentum to carry.
void ConservativeScheme::rest_nodes(const Threads& threads) {
  for_runs(threads, wet_.runs(), [&](const Run& r) {
    for (NodePlanes* n : {&work_.x, &work_.y})
      std::fill_n(n->velocity_m_s.row(r.y) + r.x0, r.size(), 0.0f);
  });
}

void ConservativeScheme::find_rheology(const CanvasState& state, const StepInput& in,
                                       const Run& r) {
  // 4a. Height, stiffness and viscosity of each cell (R3, R12, R13).
  fetch({&work_.height_m, &work_.mobility_frac, &work_.viscosity_m2_s, &work_.crowding_m_s2}, r);
  const Rheology rheology = make_rheology(in.model);
  const auto n = static_cast<std::size_t>(r.size());
  const float* depth = state.depth_m.row(r.y) + r.x0;
  height_row(state.base_m.row(r.y) + r.x0, depth, r.size(), work_.height_m.row(r.y) + r.x0);
  // The total amounts are needed only here: they use the memory of the crowding, which is not known
  // yet.
  const std::span<float> amount{work_.crowding_m_s2.row(r.y) + r.x0, n};
  total_amount_row(state, in.amount, r.y, r.x0, r.x1, amount);
  rheology_row(rheology, 0.0f, {depth, n}, amount, {work_.mobility_frac.row(r.y) + r.x0, n},
               {work_.viscosity_m2_s.row(r.y) + r.x0, n});
}

// Which tiles the solves are for. The solver's planes are zero in all others.
void ConservativeScheme::find_live(const StepInput& in) {
  // Where gravity moves stiff paint too (reading (b) of A7), all paint gives way.
  const bool all = !in.model.phi_scales_lateral;
  live_.find(*tiles_, in.threads, [&](int tile) {
    return all || tiles_->moves(tile) || gives_way(work_, tiles_->box(tile));
  });
}

// Which cells a part of a step is for. In all others the planes of the work and the velocities hold
// zeros; Multigrid::set_runs() sees to the solver's planes.
void ConservativeScheme::find_wet(CanvasState& state, const StepInput& in, float travel_cells) {
  // As far as paint comes, rounded up, and two cells more, which slopes and drag are seen from.
  const int reach = static_cast<int>(std::min(travel_cells, 1e6f)) + 3;
  if (leaves_out_)
    wet_.find(*tiles_, state.depth_m, reach, in.threads);
  else
    wet_.find_all(*tiles_);
  // The first part finds a fresh workspace, which holds zeros already, but any velocities.
  for_cells_left(knows_before_ ? wet_before_ : tiles_->runs(), wet_.runs(),
                 [&](int y, int x0, int x1) {
                   if (knows_before_) work_.clear({x0, x1, y, y + 1});
                   for (Field<float>* u : {&state.velocity_x_m_s, &state.velocity_y_m_s})
                     forget(u->row(y) + x0, u->row(y) + x1);
                 });
  wet_before_ = wet_.runs();
  knows_before_ = true;
}

void ConservativeScheme::find_faces(const CanvasState& state, const StepInput& in, const Run& r) {
  // 4b. Depth, mobility, viscosity and friction of each face. A face at the canvas's edge or beside
  // a sleeping tile is closed.
  const FaceParameters p{in.model.dry_film_m(), in.model.friction_viscosity_floor_m2_s,
                         3 * in.dt_s * in.model.bed_friction};
  const auto cells = [&](int x, int y) {
    return CellRow{state.depth_m.row(y) + x, state.base_m.row(y) + x, work_.height_m.row(y) + x,
                   work_.mobility_frac.row(y) + x, work_.viscosity_m2_s.row(y) + x};
  };
  for (const NodePlanes* n : {&work_.x, &work_.y})
    fetch({&n->depth_m, &n->mobility_frac, &n->viscosity_m2_s, &n->friction_frac}, r);
  close_faces_row(1, faces_at(work_.x, r.x1 - 1, r.y));
  for_open_faces(*tiles_, Axis::kX, r, [&](int x, int n) {
    face_row(p, cells(x, r.y), cells(x + 1, r.y), n, faces_at(work_.x, x, r.y));
  });
  if ((r.y + 1) % tiles_->tile_height() == 0 || r.y + 1 == geometry_.height)
    close_faces_row(r.size(), faces_at(work_.y, r.x0, r.y));
  for_open_faces(*tiles_, Axis::kY, r, [&](int x, int n) {
    face_row(p, cells(x, r.y), cells(x, r.y + 1), n, faces_at(work_.y, x, r.y));
  });
}

void ConservativeScheme::pin_edges(const CanvasState& state, const StepInput& in) {
  // 4c. Contact lines: surface tension holds the faces between a film and bare canvas.
  if (!(in.model.front_depth_m > 0)) return;
  const ContactLine line(in.model.front_depth_m, in.model.front_reach_m, state.geometry.dx_m(),
                         state.geometry.dy_m());
  for_runs(in.threads, wet_.runs(), [&](const Run& r) {
    for_open_faces(*tiles_, Axis::kX, r, [&](int x, int n) {
      line.pin_row(state.depth_m, Axis::kX, x, r.y, n, work_.x.friction_frac.row(r.y) + x);
    });
    for_open_faces(*tiles_, Axis::kY, r, [&](int x, int n) {
      line.pin_row(state.depth_m, Axis::kY, x, r.y, n, work_.y.friction_frac.row(r.y) + x);
    });
  });
}

void ConservativeScheme::foresee_surface(const CanvasState& state, const StepInput& in,
                                         const Run& r) {
  // 4e. h - dt div(d u~), as far as it is trusted.
  fetch({&work_.surface_m}, r);
  const float* height = work_.height_m.row(r.y) + r.x0;
  float* surface = work_.surface_m.row(r.y) + r.x0;
  height_rhs_row(fluxes(r), height, in.dt_s / state.geometry.dx_m(),
                 in.dt_s / state.geometry.dy_m(), r.size(), surface);
  foresee_row(state.depth_m.row(r.y) + r.x0, height, carried_by_tension(in.model), r.size(),
              surface);
}

// 4f. A surface goes on into tiles that sleep: paint does not cross their borders, but its
// curvature there is that of all paint. Else what rests would begin to move when its neighbour
// falls asleep.
void ConservativeScheme::copy_sleeping_neighbours(const CanvasState& state) {
  const auto copy = [&](int y, int x0, int x1) {
    for (int x = x0; x < x1; ++x)
      work_.surface_m.row(y)[x] = state.base_m(x, y) + state.depth_m(x, y);
  };
  for (const Run& r : live_runs_) {
    if (r.x0 > 0) copy(r.y, r.x0 - 1, r.x0);
    if (r.x1 < geometry_.width) copy(r.y, r.x1, r.x1 + 1);
    for (const int y : {r.y - 1, r.y + 1})
      tiles_->for_sleeping_beside(r, y, [&](int x0, int x1) { copy(y, x0, x1); });
  }
}

void ConservativeScheme::apply_viscosity(const CanvasState& state, const StepInput& in) {
  if (!tiles_->moves()) return;  // velocities of 0 are solved
  Multigrid& solver = work_.solver;
  const float per_dx2 = in.dt_s / (state.geometry.dx_m() * state.geometry.dx_m());
  const float per_dy2 = in.dt_s / (state.geometry.dy_m() * state.geometry.dy_m());
  // The stiffest coupling that can occur decides how many grids the solve needs.
  const float nu = std::max(in.model.nu_max_m2_s, in.model.friction_viscosity_floor_m2_s);
  const int levels = solver.levels_for(nu * std::max(per_dx2, per_dy2));
  // 5. One implicit solve for each component of the velocity: (1 - dt div nu grad) u = u~.
  for (NodePlanes* nodes : {&work_.x, &work_.y}) {
    const WorkPlane& depth = nodes->depth_m;
    const WorkPlane& viscosity = nodes->viscosity_m2_s;
    const auto fill = [&](const Run& r) {
      const int x = r.x0;
      const int y = r.y;
      const ViscousNodes v{depth.row(y - 1) + x,     depth.row(y) + x,
                           depth.row(y + 1) + x,     viscosity.row(y) + x,
                           viscosity.row(y + 1) + x, nodes->velocity_m_s.row(y) + x};
      viscous_row(v, per_dx2, per_dy2, r.size(),
                  {solver.cx().row(y) + x, solver.cy().row(y) + x, solver.zero_order().row(y) + x,
                   solver.rhs().row(y) + x});
    };
    solver.solve(in.model.viscosity_cycles, levels, in.threads,
                 {.guess = &solver.rhs(), .fill = {fill}});
    swap(solver.solution(), nodes->velocity_m_s);
  }
}

// 6a. Between which cells paint has one surface, also towards cells that sleep. The weights lie on
// planes that the solver does not need yet.
void ConservativeScheme::find_films(const CanvasState& state, const Run& r) {
  const auto weigh = [&](Axis axis, int x, int y, int n) {
    const float cell_m = axis == Axis::kX ? state.geometry.dx_m() : state.geometry.dy_m();
    const float* a = state.depth_m.row(y) + x;
    const float* b = axis == Axis::kX ? a + 1 : state.depth_m.row(y + 1) + x;
    WorkPlane& weight = axis == Axis::kX ? work_.solver.cx() : work_.solver.cy();
    film_weight_row(a, b, kLeastFilm_m, 1 / (cell_m * cell_m), n, weight.row(y) + x);
  };
  const bool left = r.x0 > 0, right = r.x1 < geometry_.width;
  if (!right) work_.solver.cx().row(r.y)[r.x1 - 1] = 0;
  const int first = left ? r.x0 - 1 : r.x0, last = right ? r.x1 : r.x1 - 1;
  if (last > first) weigh(Axis::kX, first, r.y, last - first);
  if (r.y + 1 < geometry_.height) {
    weigh(Axis::kY, r.x0, r.y, r.size());
  } else {
    std::fill_n(work_.solver.cy().row(r.y) + r.x0, r.size(), 0.0f);
  }
  tiles_->for_sleeping_beside(r, r.y - 1,
                              [&](int x0, int x1) { weigh(Axis::kY, x0, r.y - 1, x1 - x0); });
}

// 7a, before the solver: cells that sleep have no couplings.
void ConservativeScheme::forget_sleeping_films(const Run& r) {
  if (r.x0 > 0) work_.solver.cx().row(r.y)[r.x0 - 1] = 0;
  tiles_->for_sleeping_beside(r, r.y - 1, [&](int x0, int x1) {
    std::fill(work_.solver.cy().row(r.y - 1) + x0, work_.solver.cy().row(r.y - 1) + x1, 0.0f);
  });
}

// 6b. The head of that surface's curvature. Gravity and bed friction: u* = friction (u - dt
// mobility g), on the faces of one run.
void ConservativeScheme::apply_gravity(const CanvasState& state, const StepInput& in,
                                       const Run& r) {
  const auto apply = [&](NodePlanes& n, float speed) {
    const LateralGravity g{speed, in.model.dry_film_m(), in.model.phi_scales_lateral};
    force_row(g, n.depth_m.row(r.y) + r.x0, n.mobility_frac.row(r.y) + r.x0,
              n.friction_frac.row(r.y) + r.x0, r.size(), n.velocity_m_s.row(r.y) + r.x0);
  };
  apply(work_.x, in.dt_s * in.gravity_m_s2.x);
  apply(work_.y, in.dt_s * in.gravity_m_s2.y);
  Multigrid& solver = work_.solver;
  const WorkPlane& surface = work_.surface_m;
  const int x = r.x0;
  const EdgeDrop most = {0.5f * kContactSlope * state.geometry.dx_m(),
                         0.5f * kContactSlope * state.geometry.dy_m(),
                         carried_by_tension(in.model)};
  curvature_row({surface.row(r.y - 1) + x, surface.row(r.y) + x, surface.row(r.y + 1) + x,
                 state.base_m.row(r.y) + x, solver.cx().row(r.y) + x, solver.cy().row(r.y - 1) + x,
                 solver.cy().row(r.y) + x},
                most, in.model.tension_m3_s2(), r.size(), solver.zero_order().row(r.y) + x);
}

FluxRow ConservativeScheme::fluxes(const Run& r) const {
  const auto here = [&](const WorkPlane& p) { return p.row(r.y) + r.x0; };
  const auto above = [&](const WorkPlane& p) { return p.row(r.y - 1) + r.x0; };
  return {here(work_.x.depth_m),       here(work_.x.velocity_m_s), above(work_.y.depth_m),
          above(work_.y.velocity_m_s), here(work_.y.depth_m),      here(work_.y.velocity_m_s)};
}

// 6c. Crowding: paint that would come deeper than max_medium pushes back.
void ConservativeScheme::find_crowding(const CanvasState& state, const StepInput& in,
                                       const Run& r) {
  const float full = in.model.max_medium_m;
  const Crowding crowding{full, kCrowdedFrac * full, in.model.crowding_m_s2};
  float* crowded = work_.crowding_m_s2.row(r.y) + r.x0;
  height_rhs_row(fluxes(r), work_.height_m.row(r.y) + r.x0, in.dt_s / state.geometry.dx_m(),
                 in.dt_s / state.geometry.dy_m(), r.size(), crowded);
  crowding_row(crowding, state.depth_m.row(r.y) + r.x0, state.base_m.row(r.y) + r.x0, r.size(),
               crowded);
}

// 6d. Surface tension, and gravity that pulls paint off the canvas.
void ConservativeScheme::apply_tension(const CanvasState& state, const StepInput& in,
                                       const Run& r) {
  const float dx = state.geometry.dx_m();
  const float dy = state.geometry.dy_m();
  const float tension = in.model.tension_m3_s2();
  // Paint that hangs needs the tension: without it, its shortest waves would grow fastest (A13).
  const Vec3f& g = in.gravity_m_s2;
  const float hanging = tension > 0 ? positive(-g.z) : 0.0f;
  const float sagging = tension > 0 ? sagging_gravity(g) : 0.0f;
  const auto apply = [&](NodePlanes& n, int down, float cell_m, const WorkPlane& weight) {
    const auto here = [&](const WorkPlane& p) { return p.row(r.y) + r.x0; };
    const auto next = [&](const WorkPlane& p) { return p.row(r.y + down) + r.x0 + 1 - down; };
    const WorkPlane& head = work_.solver.zero_order();
    const WorkPlane& surface = work_.surface_m;
    capillary_force_row(
        {in.dt_s, 1 / cell_m, tension, 4 / (dx * dx) + 4 / (dy * dy), stiffest(dx, dy), hanging,
         sagging, carried_by_tension(in.model)},
        {here(weight), here(n.depth_m), here(n.mobility_frac), here(n.friction_frac), here(head),
         next(head), here(surface), next(surface)},
        r.size(), n.velocity_m_s.row(r.y) + r.x0, n.pressure_m_s.row(r.y) + r.x0);
  };
  apply(work_.x, 0, dx, work_.solver.cx());
  apply(work_.y, 1, dy, work_.solver.cy());
}

// 7a. The right side of the height equation, and its couplings: the speed that a face gains per
// unit slope.
void ConservativeScheme::fill_height(const CanvasState& state, const StepInput& in, const Run& r) {
  Multigrid& solver = work_.solver;
  forget_sleeping_films(r);
  height_rhs_row(fluxes(r), work_.height_m.row(r.y) + r.x0, in.dt_s / state.geometry.dx_m(),
                 in.dt_s / state.geometry.dy_m(), r.size(), solver.rhs().row(r.y) + r.x0);
  const float gravity = positive(in.gravity_m_s2.z);
  const auto pressure = [&](NodePlanes& n, int down, float cell_m, WorkPlane& c) {
    const float* crowded = work_.crowding_m_s2.row(r.y) + r.x0;
    const float* next = work_.crowding_m_s2.row(r.y + down) + r.x0 + 1 - down;
    pressure_row({n.depth_m.row(r.y) + r.x0, n.mobility_frac.row(r.y) + r.x0,
                  n.friction_frac.row(r.y) + r.x0, crowded, next},
                 in.dt_s * gravity, in.dt_s, in.dt_s * (1 / (cell_m * cell_m)), r.size(),
                 n.pressure_m_s.row(r.y) + r.x0, c.row(r.y) + r.x0);
  };
  pressure(work_.x, 0, state.geometry.dx_m(), solver.cx());
  pressure(work_.y, 1, state.geometry.dy_m(), solver.cy());
}

void ConservativeScheme::finish(const StepInput& in, const Run& r) {
  // 7c. The solved height drives the velocity; then the cap acts.
  const WorkPlane& height = work_.solver.solution();
  const auto one = [&](NodePlanes& n, int down, float cell_m) {
    finish_row(cap_of(in.model),
               {n.depth_m.row(r.y) + r.x0, n.pressure_m_s.row(r.y) + r.x0, height.row(r.y) + r.x0,
                height.row(r.y + down) + r.x0 + 1 - down},
               1 / cell_m, r.size(), n.velocity_m_s.row(r.y) + r.x0);
  };
  one(work_.x, 0, geometry_.dx_m());
  one(work_.y, 1, geometry_.dy_m());
}

// 7d. Slow paint stands (R14): by the length of its velocity, so that paint that runs down levels
// to the sides however slowly.
void ConservativeScheme::stand(CanvasState& state, const StepInput& in, const Run& r) const {
  for (const Field<float>* f : {&state.velocity_x_m_s, &state.velocity_y_m_s})
    fetch_row_ahead(*f, r.y, r.x0, r.x1);
  const WorkPlane& u = work_.x.velocity_m_s;
  const WorkPlane& v = work_.y.velocity_m_s;
  const float threshold = in.model.velocity_threshold_m_s;
  // The lowest faces are walls, which stand whatever lies a row beyond the plane.
  const auto at = [&](const WorkPlane& p, int right, int down) {
    return p.row(std::min(r.y + down, p.height())) + r.x0 + right;
  };
  stand_row(threshold, {at(u, 0, 0), at(u, 0, -1), at(u, 0, 1)},
            {{at(v, -1, -1), at(v, 0, -1), at(v, 1, -1), at(v, 2, -1)},
             {at(v, -1, 0), at(v, 0, 0), at(v, 1, 0), at(v, 2, 0)}},
            r.size(), state.velocity_x_m_s.row(r.y) + r.x0);
  stand_row(threshold, {at(v, 0, 0), at(v, -1, 0), at(v, 1, 0)},
            {{at(u, -1, -1), at(u, -1, 0), at(u, -1, 1), at(u, -1, 2)},
             {at(u, 0, -1), at(u, 0, 0), at(u, 0, 1), at(u, 0, 2)}},
            r.size(), state.velocity_y_m_s.row(r.y) + r.x0);
}

// 6. and 7. The solver calls the parts of both on each row while that row is in the cache.
void ConservativeScheme::solve_height(CanvasState& state, const StepInput& in) {
  const float dx = state.geometry.dx_m();
  const float dy = state.geometry.dy_m();
  const float nearest = std::min(dx, dy);
  const float held = in.model.tension_m3_s2() * (4 / (dx * dx) + 4 / (dy * dy));
  const float gravity = positive(in.gravity_m_s2.z) + sagging_gravity(in.gravity_m_s2);
  const float strongest = (gravity + held + in.model.crowding_m_s2) * in.dt_s * in.dt_s *
                          in.model.max_medium_m / (nearest * nearest);
  // 7b. The solve: h' - dt div(d K grad h') = h - dt div(d u*), K the pressure of 7a.
  work_.solver.solve(in.model.height_cycles, work_.solver.levels_for(strongest), in.threads,
                     {.guess = &work_.height_m,
                      .unit_zero_order = true,
                      .fill = {[&](const Run& r) { find_films(state, r); },
                               [&](const Run& r) { apply_gravity(state, in, r); },
                               [&](const Run& r) { find_crowding(state, in, r); },
                               [&](const Run& r) { apply_tension(state, in, r); },
                               [&](const Run& r) { fill_height(state, in, r); }},
                      .finish = [&](const Run& r) { finish(in, r); }});
  for_runs(in.threads, live_runs_, [&](const Run& r) { stand(state, in, r); });
}

std::vector<double> ConservativeScheme::memory() const {
  std::vector<double> memory = report_.numbers();
  memory.insert(memory.begin(), static_cast<double>(sleep_tile_m_));
  return memory;
}

bool ConservativeScheme::fits(std::span<const double> memory) const {
  const auto is_sum = [](double v) { return v >= 0 && v <= std::numeric_limits<float>::max(); };
  return memory.size() == 1 + StepReport::kNumbers &&
         std::all_of(memory.begin(), memory.end(), is_sum);
}

void ConservativeScheme::recall(std::span<const double> memory) {
  PENTIMENTO_CHECK(fits(memory));
  if (memory[0] > 0) make_tiles(static_cast<float>(memory[0]));
  report_.set(memory.subspan(1));
}

}  // namespace pentimento::conservative
