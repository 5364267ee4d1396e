#include "replay/estimate/time_estimate.h"

#include <algorithm>
#include <ctime>
#include <memory>

#include "replay/estimate/detail_cost.h"

namespace pentimento {

namespace {
constexpr double kStart_s = 0.1;  // the programme, OpenGL; compiled shaders are there mostly
constexpr CanvasGeometry kSmall = {256, 192, 0.2, 0.15};

/// A canvas, wet all over and tilted, with the session's planes. All else is as usual, so that
/// paint moves whatever the session's own paint would do.
std::unique_ptr<Simulation> small_canvas(const LogSession& session, const Threads& threads) {
  SimulationSetup setup;
  setup.geometry = kSmall;
  setup.model.scheme = session.model.scheme;
  setup.model.layers = session.model.layers;
  setup.basis = session.basis;
  setup.paper_m = Field<float>(kSmall.width, kSmall.height);
  CanvasState state = make_canvas_state(kSmall, setup.model.layers, session.basis.channels(),
                                        session.basis.bands(), 0.9f);
  state.depth_m.fill(0.2f * setup.model.max_medium_m);
  auto simulation = std::make_unique<Simulation>(std::move(setup), threads);
  simulation->restore(std::move(state));
  simulation->set_gravity({1, 1, 9});
  return simulation;
}

/// Of a few steps of it. Processor time, so that what else the machine does is not counted.
double processor_seconds(const LogSession& session, const Threads& threads, int steps) {
  const std::unique_ptr<Simulation> canvas = small_canvas(session, threads);
  canvas->step();
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) canvas->step();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Elapsed time of work of which a part is done by all threads.
double elapsed(double work, double shared_frac, int threads) {
  return work * (1 - shared_frac + shared_frac / threads);
}
}  // namespace

double cell_step_seconds(const LogSession& session) {
  constexpr int kSteps = 2, kProbes = 32, kPatience = 6;
  const Threads one(1);  // threads that wait for each other take processor time too
  // The fastest of several: others can only slow one down (caches, clock rate, a shared core). Six
  // in a row that are no faster end the search.
  double least_s = processor_seconds(session, one, kSteps);
  for (int probe = 1, vain = 0; probe < kProbes && vain < kPatience; ++probe) {
    const double taken_s = processor_seconds(session, one, kSteps);
    vain = taken_s < 0.99 * least_s ? 0 : vain + 1;
    least_s = std::min(least_s, taken_s);
  }
  return least_s / kSteps / (static_cast<double>(kSmall.width) * kSmall.height);
}

double job_seconds(const RenderJob& job, const LogSession& session, const PaintSurvey& survey,
                   const OutputSize& size, double cell_step_s, int threads) {
  const TimeCost cost;
  const auto stamps = static_cast<double>(survey.stamps);
  const double guide = survey.awake.cell_steps * cost.awake_cell +
                       survey.tilted_cell_steps * cost.tilted_cell +
                       survey.stamped_cells * cost.stamped_cell + stamps * cost.stamp;
  const bool follows = session.detail > 1;
  const double followed = survey.stamped_cells * cost.followed_cell +
                          survey.tilted_cell_steps * cost.followed_tilted_cell;
  const double square = static_cast<double>(session.detail) * session.detail;
  const double moved = square * (survey.awake.cell_steps * cost.fine_awake_cell +
                                 survey.awake.channel_steps * cost.fine_awake_channel +
                                 survey.tilted_cell_steps * cost.fine_tilted_cell);
  const double pictures = static_cast<double>(std::max<std::size_t>(1, job.stops.size())) *
                          (static_cast<double>(size.width) * size.height * cost.picture_pixel +
                           square * session.grid.width * session.grid.height * cost.canvas_cell);
  const double in_turn = elapsed(guide, cost.guide_shared_frac, threads) +
                         (follows ? elapsed(followed, cost.followed_shared_frac, threads) : 0);
  return kStart_s + cell_step_s * (in_turn + elapsed(pictures + (follows ? moved : 0),
                                                     cost.fine_shared_frac, threads));
}

}  // namespace pentimento
