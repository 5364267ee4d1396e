#pragma once
// `pentimento batch`: renders every log of a manifest in a process of its own, and judges what came
// of it. One that crashes, hangs or takes all memory is a row of the report.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/row.h"
#include "replay/job/control.h"

namespace pentimento {

struct BatchRequest {
  std::string manifest;
  std::string run;      // the folder of the run
  std::string program;  // that renders; empty: this one
  int jobs = 1;         // at a time
  int shard = 1, shards = 1;
  double timeout_s = 600;             // of each job
  std::int64_t memory_bytes = 0;      // of each job; 0: what the budget leaves
  std::int64_t memory_budget = 0;     // of all jobs at a time; 0: no limit
  bool pictures = true;               // shade what was painted
  bool dumps = false;                 // keep the state of each job
  int repeat = 1;                     // times that each job is done, to see that it is the same
  std::string golden;                 // a folder; empty: nothing to compare with
  std::optional<std::string> reason;  // to take the results as golden
};

struct BatchSummary {
  std::vector<BatchRow> rows;      // of this shard, in the manifest's order
  int rendered = 0;                // jobs that were run, not found done
  std::vector<std::string> taken;  // ids whose results are golden now

  int failed() const;
};

/// Errors: those of the manifest and of the golden index, kUsage, kIo, kInterrupted. What a job
/// does is no error.
Result<BatchSummary> run_batch(const BatchRequest& request, const Control& control);

/// For people, lines ending in '\n'; for programs, one JSON object.
std::string batch_text(const BatchSummary& summary);
std::string batch_json(const BatchSummary& summary);

}  // namespace pentimento
