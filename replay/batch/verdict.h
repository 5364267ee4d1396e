#pragma once
// The verdict on a job of a batch: is its result what the manifest and the golden results expect?

#include "replay/batch/golden.h"
#include "replay/batch/row.h"
#include "replay/batch/run_folder.h"

namespace pentimento {

/// Judges `result` of `job`. `golden` nullptr: there is nothing to compare with. `may_be_new`: an
/// id without a golden result passes. The golden picture that a result differs from is copied into
/// the run's folder.
BatchRow judge(const BatchJob& job, const JobResult& result, const RunFolder& run,
               const GoldenStore* golden, bool may_be_new);

}  // namespace pentimento
