#include "replay/dry_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

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
                                        session.model.layers, session.basis.channels(),
                                        session.basis.bands(), 0.9f);
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
  // Processor time, so that what else the machine does is not counted.
  const std::clock_t begin = std::clock();
  for (int i = 0; i < kSteps; ++i) canvas->step();
  const double elapsed_s =
      static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / threads.count();
  return elapsed_s / kSteps / (256.0 * 192.0);
}

constexpr double kStart_s = 0.5;      // the programme, OpenGL, the shader's compilation
constexpr double kLargeCanvas = 2.2;  // a cell of a canvas that no cache holds, against the small

/// Guide, finer canvas and pictures, from what a cell takes in a step here.
double seconds(const LogSession& session, const PaintSurvey& survey, const RenderJob& job,
               const OutputSize& size, double cell_step_s) {
  const DetailCost cost;
  const auto stamps = static_cast<double>(survey.stamps);
  const double guide =
      survey.awake_cell_steps + survey.stamped_cells * cost.stamped_cell + stamps * cost.stamp;
  const double fine = static_cast<double>(session.detail) * session.detail;
  const double detail = session.detail > 1
                            ? fine * (survey.awake_cell_steps * cost.moved_cell_steps +
                                      survey.stamped_cells * cost.stamped_cell_steps) +
                                  stamps * cost.fine_stamp
                            : 0;
  const double cells = fine * session.grid.width * session.grid.height;
  const double pixels = static_cast<double>(size.width) * size.height;
  const auto pictures = static_cast<double>(std::max<std::size_t>(1, job.stops.size()));
  return kStart_s +
         kLargeCanvas * cell_step_s *
             (guide + detail + pictures * (pixels * cost.picture_pixel + cells * cost.canvas_cell));
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
  Result<PaintSurvey> survey = survey_paint(*session, DetailCost());
  if (!survey) return survey.error();
  if (Result<void> fits = check_memory(job, *session, *survey); !fits) return fits.error();
  JobEstimate estimate;
  estimate.size = *written;
  estimate.grid = session->grid;
  estimate.detail = session->detail;
  estimate.steps = session->steps;
  estimate.needs = job_needs(job, *session, *survey);
  estimate.survey = *survey;
  estimate.log_sha256 = session->plan.sha256;
  estimate.time_s =
      seconds(*session, *survey, job, *written, seconds_per_cell_step(*session, job.threads));
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
      .add("stamps", e.survey.stamps)
      .add("tiles", e.survey.tiles)
      .add("all_tiles", e.survey.all_tiles)
      .add("memory_bytes", e.needs.memory_bytes)
      .add("disk_bytes", e.needs.disk_bytes)
      .add("scratch_bytes", e.needs.scratch_bytes)
      .add("time_s", e.time_s)
      .add("log_sha256", e.log_sha256)
      .text();
}

std::string estimate_text(const JobEstimate& e) {
  constexpr std::int64_t kMB = 1'000'000;
  return fmt::format(
      "picture  {} x {} pixels\n"
      "grid     {} x {} cells, {} times finer\n"
      "steps    {}, {} stamps\n"
      "tiles    {} of {} with paint\n"
      "memory   {} MB\n"
      "disk     {} MB at most, scratch {} MB\n"
      "time     {:.0f} s\n",
      e.size.width, e.size.height, e.grid.width, e.grid.height, e.detail, e.steps, e.survey.stamps,
      e.survey.tiles, e.survey.all_tiles, e.needs.memory_bytes / kMB, e.needs.disk_bytes / kMB,
      e.needs.scratch_bytes / kMB, e.time_s);
}

}  // namespace pentimento
