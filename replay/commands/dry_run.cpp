#include "replay/commands/dry_run.h"

#include <fmt/format.h>

#include "core/base/thread_count.h"
#include "replay/estimate/time_estimate.h"
#include "replay/film/even_sides.h"
#include "replay/job/report_object.h"
#include "replay/output/output_plan.h"
#include "replay/output/output_set.h"
#include "replay/session/log_session.h"

namespace pentimento {

Result<JobEstimate> dry_run(const RenderJob& job, const Control& control) {
  if (!job.picture.outputs.empty()) {
    const auto plan = plan_outputs(job.picture.outputs, job.stops);
    if (!plan) return plan.error();
  }
  Result<LogSession> session = open_session(job, control);
  if (!session) return session.error();
  Result<OutputSize> written = written_size(job.picture, session->size);
  if (!written) return written.error();
  if (Result<void> even = check_even_sides(job.picture, session->size, session->canvas); !even)
    return even.error();
  Result<PaintSurvey> survey = survey_paint(*session, DetailCost(), control);
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
  estimate.cell_step_s = cell_step_seconds(*session);
  estimate.time_s = job_seconds(job, *session, *survey, *written, estimate.cell_step_s,
                                wanted_threads(job.threads));
  return estimate;
}

std::string estimate_json(const JobEstimate& e) {
  return ReportObject()
      .add("width", e.size.width)
      .add("height", e.size.height)
      .add("dpi", e.size.dpi)
      .add("grid_width", e.grid.width)
      .add("grid_height", e.grid.height)
      .add("detail", e.detail)
      .add("steps", e.steps)
      .add("stamps", e.survey.stamps)
      .add("stamped_cells", e.survey.stamped_cells)
      .add("awake_cell_steps", e.survey.awake.cell_steps)
      .add("tilted_cell_steps", e.survey.tilted_cell_steps)
      .add("stamped_channels", e.survey.stamped_channels)
      .add("awake_channel_steps", e.survey.awake.channel_steps)
      .add("tiles", e.survey.tiles)
      .add("all_tiles", e.survey.all_tiles)
      .add("memory_bytes", e.needs.memory_bytes)
      .add("disk_bytes", e.needs.disk_bytes)
      .add("scratch_bytes", e.needs.scratch_bytes)
      .add("cell_step_s", e.cell_step_s)
      .add("time_s", e.time_s)
      .add("log_sha256", e.log_sha256)
      .text();
}

std::string estimate_text(const JobEstimate& e) {
  constexpr std::int64_t kMB = 1'000'000;
  const auto megabytes = [](std::int64_t bytes) { return (bytes + kMB - 1) / kMB; };
  return fmt::format(
      "picture  {} x {} pixels\n"
      "grid     {} x {} cells, {} times finer\n"
      "steps    {}, {} stamps\n"
      "tiles    {} of {} with paint\n"
      "memory   {} MB\n"
      "disk     {} MB at most, scratch {} MB\n"
      "time     {:.0f} s\n",
      e.size.width, e.size.height, e.grid.width, e.grid.height, e.detail, e.steps, e.survey.stamps,
      e.survey.tiles, e.survey.all_tiles, megabytes(e.needs.memory_bytes),
      megabytes(e.needs.disk_bytes), megabytes(e.needs.scratch_bytes), e.time_s);
}

}  // namespace pentimento
