// pentimento validate LOG ...: is this log right?

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "cli/limit_options.h"
#include "replay/commands/validate.h"
#include "replay/job/report_object.h"

namespace pentimento::cli {

namespace {
constexpr const char* kValidateAbout =
    "Check logs against the rules of the format, and that the files they name are there.\n\n"
    "Examples:\n"
    "  pentimento validate session.jsonl\n"
    "  pentimento validate samples/*/*.jsonl --json";

std::string verdict_json(const std::string& file, const Result<LogFacts>& facts) {
  ReportObject json;
  json.add("file", file).add("valid", facts.ok());
  if (!facts) return json.add("error", facts.error().message).text();
  return json.add("events", facts->summary.event_count)
      .add("steps", facts->steps)
      .add("log_sha256", facts->summary.sha256)
      .text();
}
}  // namespace

int run_validate(const Arguments& arguments) {
  std::vector<std::string> files;
  bool json = false;
  bool quiet = false;
  log::ReaderOptions reading;
  CLI::App app(kValidateAbout, "pentimento validate");
  app.add_option("log", files, "action logs; `-` is standard input")->required()->type_name("");
  app.add_flag("--json", json, "a JSON array with a verdict per log");
  app.add_flag("--quiet", quiet, "say nothing of logs that are right");
  app.add_flag("--allow-outside", reading.allow_outside,
               "the logs may name files outside their folder");
  LimitOptions limits;
  limits.add_to(app, reading.limits);
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  if (Result<void> limited = limits.complete(reading.limits); !limited)
    return fail(limited.error());

  int worst = 0;
  std::vector<std::string> verdicts;
  std::string text;
  for (const std::string& file : files) {
    const Result<LogFacts> facts = validate_log(file, reading);
    verdicts.push_back(verdict_json(file, facts));
    if (!facts) {
      worst = std::max(worst, json ? exit_code(facts.error().code) : fail(facts.error()));
    } else if (!quiet) {
      text += fmt::format("{}: valid, {} events, {} steps\n", file, facts->summary.event_count,
                          facts->steps);
    }
  }
  const int printed = print(json ? json_array(verdicts) + "\n" : text);
  return worst != 0 ? worst : printed;
}

}  // namespace pentimento::cli
