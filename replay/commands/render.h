#pragma once
// `pentimento render`: a log becomes pictures and state dumps.

#include "core/base/result.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/job/report.h"

namespace pentimento {

/// Nothing is published unless everything could be written.
Result<JobReport> render(const RenderJob& job, const Control& control);

}  // namespace pentimento
