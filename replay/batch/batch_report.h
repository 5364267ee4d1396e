#pragma once
// `pentimento batch-report`: one report of any number of runs, which are shards of one batch, or
// the same batch again.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/row.h"

namespace pentimento {

/// A row and the run that has its files.
struct ReportRow {
  BatchRow row;
  std::string run;
};

struct BatchReport {
  std::vector<ReportRow> rows;  // one for each id, in the order of the manifests

  int failed() const;
  int not_run() const;
};

/// Merges the runs. An id that no run has done is a row of its own, "not run". Of an id that
/// several have done, the row that ended last counts. Two results of one key that differ are a
/// failure. Errors: kBadInput (no run of a batch), kIo.
Result<BatchReport> merge_runs(const std::vector<std::string>& runs);

/// JUnit's XML: one test case for each id, named by it.
std::string junit_xml(const BatchReport& report);

/// Writes the pages into `folder`: index.html, and the pictures that it shows. The page needs no
/// network and no server. Errors: kIo.
Result<void> write_html(const BatchReport& report, const std::string& folder);

/// For people, lines ending in '\n'; for programs, one JSON object.
std::string report_rows_text(const BatchReport& report);
std::string report_rows_json(const BatchReport& report);

}  // namespace pentimento
