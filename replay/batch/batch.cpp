#include "replay/batch/batch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "replay/batch/golden.h"
#include "replay/batch/run_folder.h"
#include "replay/batch/verdict.h"
#include "replay/batch/workers.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;

/// A batch from its manifest to its last row.
class BatchRun {
 public:
  BatchRun(const BatchRequest& request, const Control& control, RunFolder run)
      : request_(request), control_(control), run_(std::move(run)) {}

  Result<void> begin();
  Result<void> render();
  Result<BatchSummary> conclude();

 private:
  Result<std::deque<Task>> tasks();
  Result<void> found(const Task& task, const JobResult& result);
  Result<void> settle(std::size_t index, const JobResult& result, const std::string& contradiction);
  bool has_files(const JobResult& result) const;
  WorkerLimits limits() const;

  const BatchRequest& request_;
  const Control& control_;
  RunFolder run_;
  Manifest manifest_;
  std::vector<BatchJob> jobs_;  // of the shard
  std::optional<GoldenStore> golden_;
  std::vector<BatchRow> rows_;
  int rendered_ = 0, done_ = 0;
};

Result<void> BatchRun::begin() {
  Result<Manifest> manifest = read_manifest(request_.manifest);
  if (!manifest) return manifest.error();
  manifest_ = std::move(*manifest);
  if (!request_.golden.empty()) {
    Result<GoldenStore> golden = GoldenStore::open(request_.golden);
    if (!golden) return golden.error();
    golden_ = std::move(*golden);
  }
  // Every shard writes the whole manifest, so that a report knows what did not run.
  if (Result<void> wrote = run_.write_manifest(manifest_.jobs); !wrote) return wrote;
  for (const BatchJob& job : manifest_.jobs)
    if (shard_of(job.id, request_.shards) == request_.shard) jobs_.push_back(job);
  rows_.resize(jobs_.size());
  return {};
}

WorkerLimits BatchRun::limits() const {
  WorkerLimits limits;
  std::error_code ignored;
  limits.program = request_.program.empty() ? fs::read_symlink("/proc/self/exe", ignored).string()
                                            : fs::absolute(request_.program, ignored).string();
  limits.folder = manifest_.folder;
  limits.at_once = std::max(1, request_.jobs);
  limits.timeout_s = request_.timeout_s;
  limits.memory_bytes = request_.memory_bytes;
  limits.memory_budget = request_.memory_budget;
  limits.pictures = request_.pictures;
  limits.dumps = request_.dumps;
  return limits;
}

/// Whether everything that is wanted of a result was written.
bool BatchRun::has_files(const JobResult& result) const {
  std::error_code ignored;
  return result.done.code != 0 ||
         ((!request_.pictures || fs::exists(run_.file_of(result.key, "picture.png"), ignored)) &&
          (!request_.dumps || fs::exists(run_.file_of(result.key, "state.h5"), ignored)));
}

/// What is still to be run; rows of what is done are settled at once.
Result<std::deque<Task>> BatchRun::tasks() {
  std::deque<Task> tasks;
  const std::string build = build_key(limits().program);
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    if (Result<void> go = control_.go_on(); !go) return go.error();
    Task task{i, jobs_[i], inputs_of(jobs_[i], manifest_.folder, build).key()};
    const std::optional<JobResult> standing = run_.find(task.key);
    const bool is_done = standing && standing->is_final() && has_files(*standing);
    if (is_done) {
      if (Result<void> settled = settle(i, *standing, ""); !settled) return settled.error();
    }
    // A job that is done is repeated all the same if it is to be done several times.
    for (int turn = is_done ? 1 : 0; turn < request_.repeat; ++turn) tasks.push_back(task);
  }
  return tasks;
}

Result<void> BatchRun::found(const Task& task, const JobResult& result) {
  ++rendered_;
  const std::optional<JobResult> standing = run_.find(task.key);
  const bool contradicts =
      standing && standing->is_final() && result.is_final() &&
      (standing->done.code != result.done.code || standing->state_sha256 != result.state_sha256);
  return settle(
      task.index, result,
      contradicts
          ? fmt::format("not deterministic: the same job gave {} (exit {}) and {} (exit {})",
                        standing->state_sha256, standing->done.code, result.state_sha256,
                        result.done.code)
          : "");
}

Result<void> BatchRun::settle(std::size_t index, const JobResult& result,
                              const std::string& contradiction) {
  const bool updates = request_.reason.has_value();
  BatchRow row =
      judge(jobs_[index], result, run_, golden_ && !updates ? &*golden_ : nullptr, false);
  if (!contradiction.empty()) {
    row.kind = RowKind::kNotDeterministic;
    row.reasons.insert(row.reasons.begin(), contradiction);
  }
  const BatchRow& before = rows_[index];
  if (before.kind == RowKind::kNotDeterministic) row = before;  // a later turn does not mend it
  if (const std::optional<BatchRow> last = run_.row(row.id)) {
    row.last_wall_s =
        last->key == row.key ? last->last_wall_s : std::optional<double>(last->result.done.wall_s);
    // That a job gave two results stays true when a later batch finds one of them.
    if (last->key == row.key && last->kind == RowKind::kNotDeterministic) row = *last;
  }
  if (before.id.empty()) ++done_;
  if (!row.passed() && before.id.empty())
    control_.warning(fmt::format("{}: {}", row.id, row.reasons.front()));
  rows_[index] = row;
  control_.report({"batch", done_, static_cast<std::int64_t>(jobs_.size())});
  return run_.write_row(row);
}

Result<void> BatchRun::render() {
  Result<std::deque<Task>> waiting = tasks();
  if (!waiting) return waiting.error();
  Workers workers(limits(), run_,
                  [&](const Task& task, const JobResult& result) { return found(task, result); });
  Result<void> ran = workers.run(std::move(*waiting), control_);
  if (!ran && ran.error().code == ErrorCode::kInterrupted)
    return Error{ErrorCode::kInterrupted,
                 fmt::format("interrupted; {} of {} jobs are done, and the same command goes on",
                             done_, jobs_.size())};
  return ran;
}

Result<BatchSummary> BatchRun::conclude() {
  BatchSummary summary;
  summary.rendered = rendered_;
  summary.rows = rows_;
  if (!request_.reason) return summary;
  std::vector<BatchRow> right;
  for (const BatchRow& row : rows_)
    if (row.passed()) right.push_back(row);
  Result<std::vector<std::string>> taken = golden_->update(right, run_, *request_.reason);
  if (!taken) return taken.error();
  summary.taken = std::move(*taken);
  return summary;
}
}  // namespace

int BatchSummary::failed() const {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const BatchRow& row) { return !row.passed(); }));
}

Result<BatchSummary> run_batch(const BatchRequest& request, const Control& control) {
  if (request.reason && request.golden.empty())
    return Error{ErrorCode::kUsage, "--update-golden needs --golden DIR"};
  if (request.reason && request.reason->find_first_not_of(" \t") == std::string::npos)
    return Error{ErrorCode::kUsage, "--update-golden needs a reason"};
  Result<RunFolder> run = RunFolder::make(request.run);
  if (!run) return run.error();
  BatchRun batch(request, control, std::move(*run));
  if (Result<void> begun = batch.begin(); !begun) return begun.error();
  if (Result<void> rendered = batch.render(); !rendered) return rendered.error();
  return batch.conclude();
}

std::string batch_text(const BatchSummary& summary) {
  std::string text;
  for (const BatchRow& row : summary.rows)
    if (!row.passed())
      text += fmt::format("{}: {}: {}\n", row.id, name_of(row.kind), row.reasons.front());
  for (const std::string& id : summary.taken) text += fmt::format("{}: golden now\n", id);
  return text + fmt::format("{} jobs, {} rendered now, {} failed\n", summary.rows.size(),
                            summary.rendered, summary.failed());
}

std::string batch_json(const BatchSummary& summary) {
  using nlohmann::json;
  json out = {{"jobs", summary.rows.size()},
              {"rendered", summary.rendered},
              {"failed", summary.failed()},
              {"golden_taken", summary.taken},
              {"rows", json::array()}};
  for (const BatchRow& row : summary.rows) out["rows"].push_back(json::parse(row_json(row)));
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace pentimento
