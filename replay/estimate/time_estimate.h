#pragma once
// How long a job will take, before it is begun: what its log lays out, times what a cell costs on
// this machine.

#include "replay/estimate/paint_survey.h"
#include "replay/job/render_job.h"
#include "replay/session/log_session.h"

namespace pentimento {

/// Processor time that a cell of a small wet canvas with the session's planes takes in a step, on
/// one thread. Measured in half a second.
double cell_step_seconds(const LogSession& session);

/// Time by the clock, were the machine idle, of the job on `threads` threads. `survey` is of the
/// session, `size` that of the picture.
double job_seconds(const RenderJob& job, const LogSession& session, const PaintSurvey& survey,
                   const OutputSize& size, double cell_step_s, int threads);

}  // namespace pentimento
