#include "replay/batch/batch_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "replay/batch/run_folder.h"

namespace pentimento {

namespace {
/// Whether two rows contradict each other: the same inputs and build, and not the same end.
bool contradict(const JobResult& a, const JobResult& b) {
  return a.key == b.key && a.is_final() && b.is_final() &&
         (a.done.code != b.done.code || a.state_sha256 != b.state_sha256);
}

void join(ReportRow& standing, const BatchRow& other, const std::string& run) {
  const bool contradicts = contradict(standing.row.result, other.result);
  const std::string a = standing.row.result.state_sha256, b = other.result.state_sha256;
  // What ran counts more than what did not, and the later more than the earlier.
  const bool later =
      other.kind != RowKind::kNotRun && (standing.row.kind == RowKind::kNotRun ||
                                         other.result.finished > standing.row.result.finished);
  if (later) standing = {other, run};
  if (!contradicts) return;
  standing.row.kind = RowKind::kNotDeterministic;
  standing.row.reasons.insert(standing.row.reasons.begin(),
                              fmt::format("not deterministic: the same job gave {} and {}", a, b));
}

BatchRow not_run(const std::string& id) {
  BatchRow row;
  row.id = id;
  row.reasons = {"not run"};
  return row;
}
}  // namespace

int BatchReport::failed() const {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(),
                                        [](const ReportRow& one) { return !one.row.passed(); }));
}

int BatchReport::not_run() const {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(), [](const ReportRow& one) {
    return one.row.kind == RowKind::kNotRun;
  }));
}

Result<BatchReport> merge_runs(const std::vector<std::string>& runs) {
  BatchReport report;
  std::map<std::string, std::size_t> place;
  for (const std::string& path : runs) {
    Result<RunFolder> run = RunFolder::open(path);
    if (!run) return run.error();
    Result<std::vector<BatchJob>> jobs = run->manifest();
    if (!jobs) return jobs.error();
    for (const BatchJob& job : *jobs) {
      const BatchRow row = run->row(job.id).value_or(not_run(job.id));
      const auto [found, is_new] = place.try_emplace(job.id, report.rows.size());
      if (is_new) {
        report.rows.push_back({row, path});
      } else {
        join(report.rows[found->second], row, path);
      }
    }
  }
  return report;
}

std::string report_rows_text(const BatchReport& report) {
  std::string text;
  for (const ReportRow& one : report.rows)
    if (!one.row.passed())
      text += fmt::format("{}: {}: {}\n", one.row.id, name_of(one.row.kind),
                          one.row.reasons.empty() ? "" : one.row.reasons.front());
  return text + fmt::format("{} jobs, {} failed, {} of them not run\n", report.rows.size(),
                            report.failed(), report.not_run());
}

std::string report_rows_json(const BatchReport& report) {
  using nlohmann::json;
  json out = {{"jobs", report.rows.size()},
              {"failed", report.failed()},
              {"not_run", report.not_run()},
              {"rows", json::array()}};
  for (const ReportRow& one : report.rows) {
    out["rows"].push_back(json::parse(row_json(one.row)));
    out["rows"].back()["run"] = one.run;
  }
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace pentimento
