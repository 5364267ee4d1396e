#pragma once
// `pentimento render`: a log becomes pictures and state dumps.

#include "core/result.h"
#include "replay/control.h"
#include "replay/render_job.h"
#include "replay/report.h"

namespace pentimento {

/// Nothing is published unless everything could be written.
Result<JobReport> render(const RenderJob& job, const Control& control);

}  // namespace pentimento
