#include "replay/dry_run.h"

#include <fmt/format.h>

#include <chrono>

#include "replay/json_object.h"
#include "replay/log_session.h"
#include "replay/output_plan.h"
#include "replay/output_set.h"
#include "replay/timeline/step_clock.h"

namespace pentimento {

namespace {
/// A canvas of 256 x 192 cells, wet all over and tilted, in the session's model.
std::unique_ptr<Simulation> small_canvas(const LogSession& session, const Threads& threads) {
  SimulationSetup setup;
  setup.geometry = {256, 192, session.grid.width_m, session.grid.height_m};
  setup.model = session.model;
  setup.basis = session.basis;
  setup.dt_s = StepClock(session.reader->header().steps_per_second).dt_s();
  setup.paper_m = Field<float>(setup.geometry.width, setup.geometry.height);
  auto simulation = std::make_unique<Simulation>(std::move(setup), threads);
  CanvasState state = make_canvas_state({256, 192, session.grid.width_m, session.grid.height_m},
                                        session.model.layers, session.basis.channels(), 3, 0.9f);
  state.depth_m.fill(0.2f * session.model.max_medium_m);
  simulation->restore(std::move(state));
  simulation->set_gravity({1, 1, 9});
  return simulation;
}

double seconds_per_cell_step(const LogSession& session, int thread_count) {
  constexpr int kSteps = 8;
  const Threads threads(thread_count);
  const std::unique_ptr<Simulation> canvas = small_canvas(session, threads);
  canvas->step();
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kSteps; ++i) canvas->step();
  const double elapsed_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return elapsed_s / kSteps / (256.0 * 192.0);
}
}  // namespace

Result<JobEstimate> dry_run(const RenderJob& job, const Control& control) {
  if (!job.picture.outputs.empty()) {
    const auto plan = plan_outputs(job.picture.outputs, job.stops);
    if (!plan) return plan.error();
  }
  Result<LogSession> session = open_session(job, control);
  if (!session) return session.error();
  Result<OutputSize> written = written_size(job.picture, session->size);
  if (!written) return written.error();
  if (Result<void> fits = check_memory(job, *session); !fits) return fits.error();
  JobEstimate estimate;
  estimate.size = *written;
  estimate.grid = session->grid;
  estimate.detail = session->detail;
  estimate.steps = session->steps;
  estimate.needs = job_needs(job, *session);
  estimate.log_sha256 = session->plan.sha256;
  estimate.time_s = seconds_per_cell_step(*session, job.threads) *
                    static_cast<double>(session->steps) * session->grid.width *
                    session->grid.height;
  return estimate;
}

std::string estimate_json(const JobEstimate& e) {
  return JsonObject()
      .add("width", e.size.width)
      .add("height", e.size.height)
      .add("dpi", e.size.dpi)
      .add("grid_width", e.grid.width)
      .add("grid_height", e.grid.height)
      .add("detail", e.detail)
      .add("steps", e.steps)
      .add("memory_bytes", e.needs.memory_bytes)
      .add("disk_bytes", e.needs.disk_bytes)
      .add("time_s", e.time_s)
      .add("log_sha256", e.log_sha256)
      .text();
}

std::string estimate_text(const JobEstimate& e) {
  return fmt::format(
      "picture  {} x {} pixels\n"
      "grid     {} x {} cells\n"
      "steps    {}\n"
      "memory   {} MB\n"
      "disk     {} MB at most\n"
      "time     {:.0f} s at most (idle steps and dry canvas cost less)\n",
      e.size.width, e.size.height, e.grid.width, e.grid.height, e.steps,
      e.needs.memory_bytes / 1'000'000, e.needs.disk_bytes / 1'000'000, e.time_s);
}

}  // namespace pentimento
