#pragma once
// `pentimento relight`: a state dump is shaded again in other light, without simulation. In the
// same light it gives the render's picture bit for bit.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/job/report.h"

namespace pentimento {

struct RelightJob {
  std::string state;
  SizeRequest size;
  LightChoice light;
  std::string palette;                              // --palette; empty: the dump's own
  std::optional<std::string> illuminant, observer;  // in place of the dump's
  std::string light_path;                           // "orbit" or a file; empty: one picture
  int frames = 0;                                   // of the path
  PictureChoice picture;
  int threads = 0;
  std::string command;  // without its -o
};

/// Does the job. Errors: those of the dump; kUsage for outputs that are no pictures, or for a lamp
/// that follows gravity, which a dump does not tell.
Result<JobReport> relight(const RelightJob& job, const Control& control);

}  // namespace pentimento
