#pragma once
// What a job will need, before it is begun: a job that cannot fit is refused at once, not after
// hours.

#include <cstdint>

#include "core/base/result.h"
#include "replay/estimate/paint_survey.h"
#include "replay/job/render_job.h"
#include "replay/session/log_session.h"

namespace pentimento {

struct JobNeeds {
  std::int64_t memory_bytes = 0;    // at the peak
  std::int64_t disk_bytes = 0;      // of all outputs; pictures as if they did not compress
  std::int64_t scratch_bytes = 0;   // of the detail canvas, if it is in --scratch
  std::int64_t resident_bytes = 0;  // what memory has room for of that canvas
  std::int64_t picture_bytes = 0;   // the pictures' part of disk_bytes
};

/// Whether a large canvas takes memory only where there is paint, so that job_needs() depends on
/// PaintSurvey::reached_share.
bool memory_follows_paint(const LogSession& session);

/// `survey` is of the session.
JobNeeds job_needs(const RenderJob& job, const LogSession& session, const PaintSurvey& survey);

/// kLimit if the memory is over the job's limit, or over what the machine has: one line with what
/// it would need and the options that would make it fit.
Result<void> check_memory(const RenderJob& job, const LogSession& session,
                          const PaintSurvey& survey);

}  // namespace pentimento
