// pentimento batch-report RUN ...: one report of any number of runs.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "formats/io/publish.h"
#include "replay/batch/batch_report.h"

namespace pentimento::cli {

namespace {
constexpr const char* kBatchReportAbout =
    "Merge the runs of `batch`, shards of one or the same again, into one report. Exit code 1: a\n"
    "job failed or did not run.\n\n"
    "Examples:\n"
    "  pentimento batch-report run --html report\n"
    "  pentimento batch-report run-1 run-2 run-3 --junit report.xml --html report";

Result<void> write(const BatchReport& report, const std::string& junit, const std::string& html) {
  if (!junit.empty()) {
    Result<Published> done = publish_bytes(junit, junit_xml(report));
    if (!done) return done.error();
  }
  return html.empty() ? Result<void>() : write_html(report, html);
}
}  // namespace

int run_batch_report(const Arguments& arguments) {
  std::vector<std::string> runs;
  std::string junit, html;
  bool json = false;
  CLI::App app(kBatchReportAbout, "pentimento batch-report");
  app.add_option("runs", runs, "folders of runs")->required()->type_name("");
  app.add_option("--junit", junit, "write JUnit's XML, `-` to standard output")->type_name("FILE");
  app.add_option("--html", html, "write pages into this folder")->type_name("DIR");
  app.add_flag("--json", json, "one JSON object");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  if (json && junit == "-")
    return fail({ErrorCode::kUsage, "--json and --junit - both want standard output"});
  Result<BatchReport> report = merge_runs(runs);
  if (!report) return fail(report.error());
  if (Result<void> written = write(*report, junit, html); !written) return fail(written.error());
  if (junit != "-") {
    const int printed = print(json ? report_rows_json(*report) + "\n" : report_rows_text(*report));
    if (printed != 0) return printed;
  }
  return report->failed() == 0 ? 0 : 1;
}

}  // namespace pentimento::cli
