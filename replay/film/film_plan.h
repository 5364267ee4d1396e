#pragma once
// The frames of a film, and the files of each.

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "formats/log/reader.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/output/output_plan.h"

namespace pentimento {

struct FilmPlan {
  std::vector<std::int64_t> steps;  // done at each frame
  std::vector<std::vector<PlannedOutput>>
      files;  // of each frame; the last has the other files, too
};

/// Whether the job makes a film: it writes a video, or says how many frames there are.
bool makes_film(const RenderJob& job);

/// Reads the log once and rewinds it. `steps`: those of the whole log. Errors: the reader's; kUsage
/// for options that do not go with a film.
Result<FilmPlan> plan_film(const RenderJob& job, log::Reader& reader, bool stepped,
                           std::int64_t steps, const Control& control);

}  // namespace pentimento
