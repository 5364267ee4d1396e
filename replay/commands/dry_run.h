#pragma once
// `--dry-run`: estimates what a job would take, without doing it.

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "replay/estimate/memory_estimate.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"

namespace pentimento {

struct JobEstimate {
  OutputSize size;
  CanvasGeometry grid;
  int detail = 1;
  std::int64_t steps = 0;
  JobNeeds needs;
  PaintSurvey survey;
  double cell_step_s = 0;  // measured on a small wet canvas on this machine, one thread
  double time_s = 0;       // estimate for this machine if it is idle
  std::string log_sha256;
};

/// Reads the log, surveys its strokes, and times a few steps of a small wet canvas. Errors: those
/// of render() before its first step.
Result<JobEstimate> dry_run(const RenderJob& job, const Control& control);

std::string estimate_json(const JobEstimate& estimate);
std::string estimate_text(const JobEstimate& estimate);

}  // namespace pentimento
