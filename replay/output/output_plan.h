#pragma once
// Finds from the `-o` options which files a job writes. The extension of a file says what it is,
// and a `%` in the name stands for the stop point.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/job/stop_points.h"

namespace pentimento {

enum class OutputKind { kPng, kExr, kState, kVideo };

struct PlannedOutput {
  std::string pattern;  // as given
  std::string path;     // `%` replaced; "-" = standard output
  OutputKind kind = OutputKind::kPng;
};

/// The files of each stop point, in the order of `stops`. Without stop points there is one unnamed
/// point. Without patterns each point has no files: such a job is replayed for its report alone.
/// Errors: kUsage (an unknown extension, several points and no `%`, one file twice).
Result<std::vector<std::vector<PlannedOutput>>> plan_outputs(
    const std::vector<std::string>& patterns, const std::vector<StopPoint>& stops);

}  // namespace pentimento
