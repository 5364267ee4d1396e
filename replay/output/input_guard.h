#pragma once
// Refuses a job that would replace one of its own inputs, or write one file twice: to lose a
// recording is worse than to be asked for another name.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/job/render_job.h"
#include "replay/log/log_files.h"
#include "replay/output/output_plan.h"

namespace pentimento {

/// A file that a job reads, and what it is in a message: "the log". "-" is standard input.
struct InputFile {
  std::string path;
  std::string what;
};

/// Refuses an output that is an input. Files are the same if they have one device and one inode:
/// other names and links do not help. What is not there, and pipes and devices, are nobody's input.
/// Errors: kUsage.
Result<void> check_inputs_stay(const std::vector<std::string>& outputs,
                               const std::vector<InputFile>& inputs);

/// Refuses one file under two names among `outputs`; a name that is given twice counts as one (a
/// film is named by each of its frames). Errors: kUsage.
Result<void> check_outputs_differ(const std::vector<std::string>& outputs);

/// The paths of all stop points.
std::vector<std::string> paths_of(const std::vector<std::vector<PlannedOutput>>& outputs);

/// What a render reads: the log, the files that it names, and those of the options.
std::vector<InputFile> files_read_by(const RenderJob& job, const LogFiles& named);

}  // namespace pentimento
