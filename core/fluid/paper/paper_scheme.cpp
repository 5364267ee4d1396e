#include "core/fluid/paper/paper_scheme.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fluid/paper/depth.h"
#include "core/fluid/paper/gravity.h"
#include "core/fluid/paper/height_sweep.h"
#include "core/fluid/paper/height_system.h"
#include "core/fluid/paper/pigment.h"
#include "core/fluid/paper/sweeps.h"
#include "core/fluid/paper/trace.h"
#include "core/fluid/paper/velocity_limits.h"
#include "core/fluid/paper/viscosity.h"
#include "core/fluid/paper/wet_front.h"
#include "core/fluid/rheology.h"

namespace pentimento::paper {

namespace {

constexpr int kRowsPerTask = 8;
constexpr int kColumnsPerTask = 64;  // whole cache lines, so that tasks share none
constexpr double kMostSteps = 9e15;  // whole numbers up to here are exact in a double

std::size_t at(int y) {
  return static_cast<std::size_t>(y);
}

/// Zeroes the cells of `box` outside `kept`.
void clear_around(Columns kept, Columns box, float* row) {
  for (const Columns& cells : around(kept, box))
    std::fill_n(row + cells.begin, cells.count(), 0.0f);
}

/// Mobility and viscosity of row y (R3, R12, R13). Stamped cells get no viscosity, so that the
/// sweeps leave the brush's velocity there (R17).
void rheology_of_row(const CanvasState& state, const StepInput& in, const Rheology& rheology, int y,
                     Columns cells, Planes& planes) {
  const std::size_t n = cells.count();
  const std::span<float> nu(planes.viscosity_m2_s.row(y) + cells.begin, n);
  const std::span<float> mobility(planes.mobility_frac.row(y) + cells.begin, n);
  const std::span<float> total(planes.system.left.row(y) + cells.begin, n);  // free until the solve
  total_amount_row(state, in.amount, y, cells.begin, cells.end, total);
  rheology_row(rheology, in.model.dry_film_m(), {state.depth_m.row(y) + cells.begin, n}, total,
               mobility, nu);
  if (y < in.contact.row_begin || y >= in.contact.row_end) return;
  const float* weight = in.contact.weight.row(y) + cells.begin;
  for (std::size_t i = 0; i < n; ++i) nu[i] = weight[i] > 0.0f ? 0.0f : nu[i];
}

}  // namespace

PaperScheme::PaperScheme(const CanvasGeometry& geometry, int /*layers*/, int channels)
    : planes_(make_planes(geometry.width, geometry.height, channels)),
      row_changed_(at(geometry.height)),
      row_flow_(at(geometry.height)),
      row_speed2_(at(geometry.height)) {}

template <typename Body>
void PaperScheme::for_live_rows(const StepInput& in, Body body) const {
  in.threads.for_ranges(rows_.row_begin(), rows_.row_end(), kRowsPerTask, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      if (!rows_.live(y).empty()) body(y, rows_.live(y));
  });
}

template <typename Body>
void PaperScheme::for_stages_of_rows(const StepInput& in, int stages, Body body) const {
  for_sweeps(in.threads, rows_.row_begin(), rows_.row_end(), stages, [&](int stage, int y) {
    if (!rows_.live(y).empty()) body(stage, y, rows_.live(y));
  });
}

template <typename Body>
void PaperScheme::for_travel_rows(const StepInput& in, Body body) const {
  in.threads.for_ranges(travel_rows_.begin, travel_rows_.end, kRowsPerTask,
                        [&](int begin, int end) {
                          for (int y = begin; y < end; ++y) body(y);
                        });
}

bool PaperScheme::step(CanvasState& state, const StepInput& in) {
  // Only cells with paint, velocity or brush, and their neighbours, are computed.
  constants_ = make_step_constants(state.geometry, in);
  rows_.find(state, in.contact, in.threads);
  ++steps_;
  if (rows_.empty()) return false;

  // R17, R16, R3, R12, R13: the brush's velocity under the tip, stiffness and viscosity of the
  // paint.
  prepare(state, in);
  // R8, R6, R7, R9: velocity and height carried along, and the implicit height.
  const Field<float>& height_m = solve_height(state, in);
  // R10, R11, R14, R15: the velocity that this height, gravity and viscosity give.
  const std::size_t velocity = solve_velocity(state, in, height_m);
  // The new height becomes depth; the new velocity carries the pigment (R18, R19).
  find_travel(state);
  for_live_rows(in, [&](int y, Columns cells) {
    row_changed_[at(y)] |= update_depth_row(planes_, height_m, y, cells, state) ? 1 : 0;
  });
  advect_pigment(state, in, velocity);
  // The fronts of films advance over bare canvas, and the state gets its velocity (A9).
  store_velocity(state, in, velocity);
  // Bookkeeping for the reports.
  max_speed_m_s_ = std::max(max_speed_m_s_, static_cast<double>(fastest_m_s()));
  live_frac_sum_ += static_cast<double>(rows_.cells()) /
                    (static_cast<double>(state.geometry.width) * state.geometry.height);
  // A stamp sets velocities before the step, so nobody knows whether they differ from the last
  // step's.
  return !in.contact.empty() ||
         std::find(row_changed_.begin(), row_changed_.end(), 1) != row_changed_.end();
}

void PaperScheme::prepare(CanvasState& state, const StepInput& in) {
  const Rheology rheology = make_rheology(in.model);
  may_move_ = travel_cells_ > 0 || !in.contact.empty();
  std::fill(row_changed_.begin(), row_changed_.end(), std::uint8_t{0});
  in.threads.for_ranges(rows_.row_begin(), rows_.row_end(), kRowsPerTask, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const Columns cells = rows_.live(y);
      prepare_margin_row(state, y, rows_.margin(y), cells, planes_);
      if (cells.empty()) continue;
      float *u = state.velocity_x_m_s.row(y), *v = state.velocity_y_m_s.row(y);
      // R17: the brush's velocity is imposed before the advection; R16: no paint crosses the
      // canvas's edge.
      if (!in.contact.empty()) {
        impose_brush_row(in.contact, y, cells, u, v);
        close_edge_row(y, state.geometry.width, state.geometry.height, cells, u, v);
      }
      rheology_of_row(state, in, rheology, y, cells, planes_);
      // R18, R19, while the row's pigment is at hand.
      if (may_move_) weigh_layers(state, in, y, cells);
    }
  });
}

const Field<float>& PaperScheme::solve_height(const CanvasState& state, const StepInput& in) {
  const auto trace = [&](int y, Columns cells) {
    trace_row(constants_, state, y, cells,
              {planes_.u_m_s[0].row(y), planes_.v_m_s[0].row(y), planes_.system.centre.row(y),
               planes_.mobility_frac});
  };
  const int sweeps = in.model.jacobi_iterations;
  const auto sweep_row = [&](int sweep, int y, Columns cells) {
    Field<float>& to = planes_.height_m[at((sweep + 1) % 2)];
    sweep_height_row(planes_.system, planes_.height_m[at(sweep % 2)], y, cells, to.row(y));
    if (sweep + 1 == sweeps)
      limit_height_row(state.base_m, constants_.max_medium_m, y, cells, to.row(y));
  };
  // R8: velocity and height are carried along, by tracing each cell back. R6, R7: the system. R9:
  // Jacobi sweeps from the old height; the last one keeps the height between base and full.
  for_stages_of_rows(in, 2 + sweeps, [&](int stage, int y, Columns cells) {
    if (stage == 0) return trace(y, cells);
    if (stage == 1) return build_height_system_row(constants_, state, y, cells, planes_);
    sweep_row(stage - 2, y, cells);
  });
  return planes_.height_m[at(sweeps % 2)];
}

std::size_t PaperScheme::solve_velocity(const CanvasState& state, const StepInput& in,
                                        const Field<float>& height_m) {
  const auto accelerate = [&](int y, Columns cells) {
    accelerate_row(constants_, state, height_m, y, cells, planes_);
    impose_brush_row(in.contact, y, cells, planes_.u_m_s[0].row(y), planes_.v_m_s[0].row(y));
    build_viscosity_row(constants_, y, cells, planes_);
  };
  // The right side stays in the first buffer. After so many sweeps the velocity is in this one.
  const auto buffer = [](int done) { return at(done == 0 ? 0 : done % 2 == 1 ? 1 : 2); };
  const Velocity right_side{planes_.u_m_s[0], planes_.v_m_s[0]};
  const int sweeps = in.model.jacobi_iterations;
  const std::size_t latest = buffer(sweeps);
  const auto sweep_row = [&](int sweep, int y, Columns cells) {
    const std::size_t from = buffer(sweep), to = buffer(sweep + 1);
    sweep_viscosity_row(planes_.system, right_side, {planes_.u_m_s[from], planes_.v_m_s[from]}, y,
                        cells, planes_.u_m_s[to].row(y), planes_.v_m_s[to].row(y));
  };
  // R10, R11, R15: slope and gravity. R13, A9: the viscosity by as many sweeps. R14, R17, R16:
  // limits, brush and edge once more, on the result.
  for_stages_of_rows(in, 1 + sweeps, [&](int stage, int y, Columns cells) {
    if (stage == 0)
      accelerate(y, cells);
    else
      sweep_row(stage - 1, y, cells);
    if (stage == sweeps) finish_row(state, in, latest, y);
  });
  return latest;
}

void PaperScheme::finish_row(const CanvasState& state, const StepInput& in, std::size_t velocity,
                             int y) {
  const Columns cells = rows_.live(y);
  float *u = planes_.u_m_s[velocity].row(y), *v = planes_.v_m_s[velocity].row(y);
  // R14: slow paint stands, fast paint is capped. Then brush (R17) and edge (R16) have the last
  // word.
  limit_speed_row(constants_, cells, u, v);
  impose_brush_row(in.contact, y, cells, u, v);
  close_edge_row(y, state.geometry.width, state.geometry.height, cells, u, v);
  mark_moved_row(state, y, cells, u, v, planes_.moved.row(y));
  // Where the row moves at all, and how fast: the pigment visits these cells only.
  Columns flow = cells;
  while (!flow.empty() && u[flow.begin] == 0.0f && v[flow.begin] == 0.0f) ++flow.begin;
  while (!flow.empty() && u[flow.end - 1] == 0.0f && v[flow.end - 1] == 0.0f) --flow.end;
  row_flow_[at(y)] = flow;
  float speed2 = 0;
  for (int x = flow.begin; x < flow.end; ++x) speed2 = std::max(speed2, u[x] * u[x] + v[x] * v[x]);
  row_speed2_[at(y)] = speed2;
}

void PaperScheme::weigh_layers(const CanvasState& state, const StepInput& in, int y,
                               Columns cells) {
  // R19: what of the bottom layer sticks; R18: how many layers share the film.
  find_free_row(state, in.amount, constants_.residue, y, cells, planes_);
  count_layers_row(state, y, cells, planes_);
}

void PaperScheme::advect_pigment(CanvasState& state, const StepInput& in, std::size_t velocity) {
  // Nothing moves: the pigment stays.
  if (travel_cells_ == 0) return;
  for_travel_rows(in, [&](int y) {
    const Columns weighed = may_move_ ? rows_.live(y) : Columns{};
    for (const Columns& cells : around(weighed, travel_columns_))
      if (!cells.empty()) weigh_layers(state, in, y, cells);
  });
  // Where paint flows in most cells, planes are exchanged, for less is to be copied then.
  std::int64_t flowing = 0;
  for (int y = rows_.row_begin(); y < rows_.row_end(); ++y)
    if (!rows_.live(y).empty()) flowing += static_cast<std::int64_t>(row_flow_[at(y)].count());
  const std::int64_t cells = std::int64_t{state.geometry.width} * state.geometry.height;
  const bool mostly_flows = 2 * flowing > cells;
  for (int layer = 0; layer < state.layers; ++layer) {
    for_live_rows(in, [&](int y, Columns) {
      // R8, R18: one layer at a time, traced back with its own velocity.
      advect_pigment_row(constants_, state, layer, planes_.u_m_s[velocity].row(y),
                         planes_.v_m_s[velocity].row(y), y, row_flow_[at(y)], planes_);
    });
    store_layer(state, in, layer, mostly_flows);
  }
}

void PaperScheme::store_layer(CanvasState& state, const StepInput& in, int layer,
                              bool mostly_flows) {
  const auto flow = [&](int y) { return rows_.live(y).empty() ? Columns{} : row_flow_[at(y)]; };
  if (!mostly_flows) {
    for_live_rows(in, [&](int y, Columns) {
      row_changed_[at(y)] |= store_pigment_row(planes_, layer, y, flow(y), state) ? 1 : 0;
    });
    return;
  }
  in.threads.for_ranges(0, state.geometry.height, kRowsPerTask, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      row_changed_[at(y)] |= complete_pigment_row(state, layer, y, flow(y), planes_) ? 1 : 0;
  });
  exchange_pigment(layer, state, planes_);
}

float PaperScheme::fastest_m_s() const {
  float speed2 = 0;
  for (int y = rows_.row_begin(); y < rows_.row_end(); ++y)
    if (!rows_.live(y).empty()) speed2 = std::max(speed2, row_speed2_[at(y)]);
  return std::sqrt(speed2);
}

void PaperScheme::find_travel(const CanvasState& state) {
  // How many cells the fastest paint comes, and the rectangle that it can have reached.
  const float cell_m = std::min(constants_.dx_m, constants_.dy_m);
  const float travel = fastest_m_s() * constants_.dt_s / cell_m;
  travel_cells_ = travel == 0.0f ? 0 : 1 + static_cast<int>(std::min(travel, 1e6f));
  const Columns live = rows_.box();
  travel_columns_ = {std::max(live.begin - travel_cells_, 0),
                     std::min(live.end + travel_cells_, state.geometry.width)};
  travel_rows_ = {std::max(rows_.row_begin() - travel_cells_, 0),
                  std::min(rows_.row_end() + travel_cells_, state.geometry.height)};
}

void PaperScheme::store_velocity(CanvasState& state, const StepInput& in, std::size_t velocity) {
  const Columns box = travel_columns_;
  Field<float>&u = planes_.u_m_s[velocity], &v = planes_.v_m_s[velocity];
  FrontInflow& inflow = planes_.inflow;
  for_travel_rows(in, [&](int y) {
    // Outside the live cells the buffers hold old numbers; inside the rectangle they must hold 0.
    clear_around(rows_.live(y), box, u.row(y));
    clear_around(rows_.live(y), box, v.row(y));
    if (travel_cells_ > 0 && !rows_.live(y).empty())
      advance_front_along_row(constants_, state, in.contact, {u, v}, y, row_flow_[at(y)], inflow);
  });
  // A9: thick films enter the thin cells before them, first along rows, then along columns.
  if (travel_cells_ > 0)
    in.threads.for_ranges(box.begin, box.end, kColumnsPerTask, [&](int begin, int end) {
      advance_front_along_columns(constants_, state, in.contact, {u, v}, {begin, end},
                                  travel_rows_.begin, travel_rows_.end, inflow);
    });
  for_travel_rows(in, [&](int y) {
    if (settle_row(state, in, velocity, y)) row_changed_[at(y)] = 1;
  });
}

bool PaperScheme::settle_row(CanvasState& state, const StepInput& in, std::size_t velocity, int y) {
  const Columns box = travel_columns_;
  const Velocity own{planes_.u_m_s[velocity], planes_.v_m_s[velocity]};
  FrontInflow& inflow = planes_.inflow;
  if (!any_inflow(inflow, y, box)) return update_velocity_row(own, y, box, state);
  // R16 for what came in, then the velocity that stays in the state.
  close_edge_row(y, state.geometry.width, state.geometry.height, box, inflow.u_m_s.row(y),
                 inflow.v_m_s.row(y));
  const bool changed = update_velocity_row(in.contact, own, inflow, y, box, state);
  clear_inflow(y, box, inflow);
  return changed;
}

std::vector<std::pair<std::string, double>> PaperScheme::statistics() const {
  const double steps = static_cast<double>(std::max<std::int64_t>(steps_, 1));
  return {{"max_speed_m_s", max_speed_m_s_}, {"live_frac", live_frac_sum_ / steps}};
}

std::vector<double> PaperScheme::memory() const {
  return {max_speed_m_s_, live_frac_sum_, static_cast<double>(steps_)};
}

bool PaperScheme::fits(std::span<const double> memory) const {
  const auto is_sum = [](double v) { return v >= 0 && v <= std::numeric_limits<float>::max(); };
  return memory.size() == 3 && std::all_of(memory.begin(), memory.end(), is_sum) &&
         memory[2] <= kMostSteps;
}

void PaperScheme::recall(std::span<const double> memory) {
  PENTIMENTO_CHECK(fits(memory));
  max_speed_m_s_ = memory[0];
  live_frac_sum_ = memory[1];
  steps_ = static_cast<std::int64_t>(memory[2]);
}

}  // namespace pentimento::paper
