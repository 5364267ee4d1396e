#pragma once
// `pentimento render`: turns a log into pictures and state dumps.

#include "core/base/result.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/job/report.h"

namespace pentimento {

/// Does the job. No file is published unless all files could be written.
Result<JobReport> render(const RenderJob& job, const Control& control);

}  // namespace pentimento
