#include "replay/batch/verdict.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "replay/compare/compare.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;

void fail(BatchRow& row, RowKind kind, std::string reason) {
  if (row.kind == RowKind::kPassed) row.kind = kind;
  row.reasons.push_back(std::move(reason));
}

void judge_end(const BatchJob& job, const JobResult& result, BatchRow& row) {
  const std::string said = result.message.empty() ? "" : ": " + result.message;
  switch (result.done.end) {
    case ChildEnd::kSignal:
      return fail(row, RowKind::kCrash,
                  fmt::format("ended by signal {} ({}){}", result.done.code,
                              strsignal(result.done.code), said));
    case ChildEnd::kTimeout:
      return fail(
          row, RowKind::kTimeout,
          fmt::format("took longer than it may and was ended after {:.1f} s", result.done.wall_s));
    case ChildEnd::kMemory:
      return fail(row, RowKind::kMemory,
                  fmt::format("held more memory than it may and was ended at {:.0f} MB",
                              static_cast<double>(result.done.peak_memory_bytes) / 1e6));
    case ChildEnd::kStopped:
      return fail(row, RowKind::kNotRun, "stopped before its end");
    case ChildEnd::kExit:
      break;
  }
  if (result.done.code != job.expect.exit_code)
    fail(row, RowKind::kExit,
         fmt::format("exit code {} instead of {}{}", result.done.code, job.expect.exit_code, said));
}

void add_differences(const Comparison& comparison, const char* of, BatchRow& row) {
  for (const PlaneDifference& d : comparison.planes)
    if (d.differing > 0)
      row.differences.push_back({of, d.name, d.max, d.differing, d.max_x, d.max_y});
  for (const std::string& note : comparison.notes)
    row.reasons.push_back(fmt::format("{}: {}", of, note));
}

/// Which fields differ, and where, if both dumps were kept.
void explain_state(const std::string& golden_dump, const std::string& dump, BatchRow& row) {
  std::error_code ignored;
  if (!fs::is_regular_file(golden_dump, ignored) || !fs::is_regular_file(dump, ignored)) return;
  const Result<Comparison> comparison = compare_files(golden_dump, dump, {}, 0);
  if (comparison) add_differences(*comparison, "state", row);
}

void keep_golden_picture(const std::string& picture, const std::string& sha256,
                         const RunFolder& run, BatchRow& row) {
  std::error_code problem;
  fs::copy_file(picture, run.golden_picture(sha256), fs::copy_options::skip_existing, problem);
  if (!problem) row.golden_picture_sha256 = sha256;
}

void judge_picture(const BatchJob& job, const std::string& golden, const std::string& sha256,
                   const RunFolder& run, BatchRow& row) {
  CompareThresholds allowed = job.expect.picture;
  if (!allowed.any()) allowed.max = kMostPictureDifference;
  const Result<Comparison> comparison =
      compare_files(golden, run.file_of(row.key, "picture.png"), allowed, 0);
  if (!comparison) return fail(row, RowKind::kPicture, comparison.error().message);
  row.flip = comparison->flip_mean;
  const bool state_failed = row.kind == RowKind::kState;
  if (comparison->equal && !state_failed) return;
  keep_golden_picture(golden, sha256, run, row);
  add_differences(*comparison, "picture", row);
  if (comparison->equal) return;
  double most = 0;
  for (const PlaneDifference& d : comparison->planes) most = std::max(most, d.max);
  fail(row, RowKind::kPicture,
       comparison->flip_mean
           ? fmt::format("the picture differs: FLIP {:.4f}, at most {:.4f} in a channel",
                         *comparison->flip_mean, most)
           : "the picture differs");
}

void judge_golden(const BatchJob& job, const GoldenEntry& entry, const GoldenStore& store,
                  const RunFolder& run, BatchRow& row) {
  if (!job.expect.any_state && entry.state_sha256 != row.result.state_sha256) {
    fail(row, RowKind::kState, "the state is not the golden one");
    explain_state(store.dump(entry), run.file_of(row.key, "state.h5"), row);
  }
  const std::string picture_sha256 = run.hash_of(row.key, "picture.png");
  // Without a picture, which a batch of states does not make, the states alone are compared.
  if (entry.picture_sha256 == picture_sha256 || picture_sha256.empty()) return;
  if (entry.picture_sha256.empty())
    return fail(row, RowKind::kPicture, "the golden result has no picture");
  const Result<std::string> golden = store.picture(entry);
  if (!golden) return fail(row, RowKind::kPicture, golden.error().message);
  judge_picture(job, *golden, entry.picture_sha256, run, row);
}
}  // namespace

BatchRow judge(const BatchJob& job, const JobResult& result, const RunFolder& run,
               const GoldenStore* golden, bool may_be_new) {
  BatchRow row;
  row.id = job.id;
  row.kind = RowKind::kPassed;
  row.key = result.key;
  row.result = result;
  judge_end(job, result, row);
  if (!row.passed() || job.expect.exit_code != 0) return row;
  if (!job.expect.state_sha256.empty() && job.expect.state_sha256 != result.state_sha256)
    fail(row, RowKind::kState,
         fmt::format("the state is {}, not {}", result.state_sha256, job.expect.state_sha256));
  if (golden == nullptr) return row;
  const GoldenEntry* entry = golden->find(job.id);
  if (entry == nullptr) {
    if (!may_be_new) fail(row, RowKind::kNoGolden, "there is no golden result to compare with");
    return row;
  }
  judge_golden(job, *entry, *golden, run, row);
  return row;
}

}  // namespace pentimento
