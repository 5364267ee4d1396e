#pragma once
// Runs jobs of a batch, several at a time, as long as memory for another one is left.

#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/job_result.h"
#include "replay/batch/run_folder.h"
#include "replay/job/control.h"
#include "replay/process/child.h"

namespace pentimento {

/// A job that is to be run.
struct Task {
  std::size_t index = 0;  // of the job in the shard
  BatchJob job;
  std::string key;
};

struct WorkerLimits {
  std::string program;
  std::string folder;  // in which the jobs run
  int at_once = 1;
  double timeout_s = 600;
  std::int64_t memory_bytes = 0;   // of a job that does not say its own; 0: no limit
  std::int64_t memory_budget = 0;  // of all at a time; 0: no limit
  bool pictures = true;
  bool dumps = false;
};

class Workers {
 public:
  /// `found` is told of each task and its result; `run` outlives the workers.
  Workers(const WorkerLimits& limits, const RunFolder& run,
          std::function<Result<void>(const Task&, const JobResult&)> found);

  /// Runs all tasks. No two with the same key run at a time. Errors: kIo; kInterrupted, after the
  /// children have ended; those of `found`.
  Result<void> run(std::deque<Task> tasks, const Control& control);

 private:
  struct RunningJob {
    Task task;
    std::string work;
    std::int64_t memory_bytes = 0;
    std::unique_ptr<Child> child;
  };
  bool may_start(const Task& task) const;
  std::int64_t memory_of(const Task& task) const;
  Result<void> start(const Task& task);
  Result<void> start_what_fits(std::deque<Task>& tasks);
  Result<void> collect(RunningJob& running);
  Result<void> collect_ended();
  void stop_all();
  std::vector<std::string> words_of(const Task& task, const std::string& work) const;

  WorkerLimits limits_;
  const RunFolder& run_;
  std::function<Result<void>(const Task&, const JobResult&)> found_;
  std::vector<RunningJob> running_;
};

}  // namespace pentimento
