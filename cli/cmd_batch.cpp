// pentimento batch MANIFEST -o RUN: many logs, each in a process of its own.

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>

#include "cli/command.h"
#include "cli/progress.h"
#include "cli/range.h"
#include "cli/talk.h"
#include "cli/values.h"
#include "replay/batch/batch.h"

namespace pentimento::cli {

namespace {
constexpr const char* kBatchAbout =
    "Render every log of a manifest, each in a process of its own, and judge the results. The "
    "same\n"
    "command again goes on from what is done. Exit code 1: a job failed.\n\n"
    "Examples:\n"
    "  pentimento batch nightly.jsonl -o run\n"
    "  pentimento batch nightly.jsonl -o run -j 4 --timeout 10m --memory-limit 2G\n"
    "  pentimento batch nightly.jsonl -o run --golden golden\n"
    "  pentimento batch nightly.jsonl -o run --golden golden --update-golden \"softer hair\"\n"
    "  pentimento batch nightly.jsonl -o run-2 --shard 2/3";

struct BatchWords {
  BatchRequest request;
  TalkOptions talk;
  bool no_pictures = false;
  std::string timeout, memory_limit, memory_budget, shard, reason;
};

void add_options(CLI::App& app, BatchWords& o) {
  BatchRequest& r = o.request;
  app.add_option("manifest", r.manifest,
                 "JSON Lines: id, log, options, expect; `-` is standard input")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", r.run, "the folder of the run")->required()->type_name("RUN");
  app.add_option("-j,--jobs", r.jobs, "jobs at a time")->check(in_range(1, 1024))->type_name("N");
  app.add_option("--shard", o.shard, "only the jobs of shard I of N")->type_name("I/N");
  app.add_option("--timeout", o.timeout, "of each job: 90s, 10m, 2h (10m)")->type_name("TIME");
  app.add_option("--memory-limit", o.memory_limit, "end a job that holds more (2G)")
      ->type_name("BYTES");
  app.add_option("--memory-budget", o.memory_budget, "of all jobs at a time (16G)")
      ->type_name("BYTES");
  app.add_option("--golden", r.golden, "a folder of results that are right, to compare with")
      ->type_name("DIR");
  app.add_option("--update-golden", o.reason, "take what differs as golden, and say why")
      ->type_name("REASON");
  app.add_flag("--no-pictures", o.no_pictures, "states only, which takes less time");
  app.add_flag("--states", r.dumps,
               "keep a dump of each state, and tell which fields differ where");
  app.add_option("--repeat", r.repeat, "do each job so many times, to see that it is the same")
      ->check(in_range(1, 1000))
      ->type_name("N");
  app.add_option("--program", r.program, "another pentimento that renders")->type_name("FILE");
}

/// Parses the options that are text.
Result<void> complete(BatchWords& o, const CLI::App& app) {
  const auto bytes = [](const char* name, const std::string& text,
                        std::int64_t& out) -> Result<void> {
    if (text.empty()) return {};
    Result<std::int64_t> value = parse_bytes(name, text);
    if (!value) return value.error();
    out = *value;
    return {};
  };
  o.request.pictures = !o.no_pictures;
  if (!o.timeout.empty()) {
    Result<double> seconds = parse_duration("--timeout", o.timeout);
    if (!seconds) return seconds.error();
    o.request.timeout_s = *seconds;
  }
  if (!o.shard.empty()) {
    Result<std::pair<int, int>> shard = parse_share("--shard", o.shard);
    if (!shard) return shard.error();
    std::tie(o.request.shard, o.request.shards) = *shard;
  }
  if (app.count("--update-golden") > 0) o.request.reason = o.reason;
  if (Result<void> limit = bytes("--memory-limit", o.memory_limit, o.request.memory_bytes); !limit)
    return limit;
  return bytes("--memory-budget", o.memory_budget, o.request.memory_budget);
}
}  // namespace

int run_batch_command(const Arguments& arguments) {
  BatchWords o;
  CLI::App app(kBatchAbout, "pentimento batch");
  add_options(app, o);
  o.talk.add_to(app);
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  if (Result<void> completed = complete(o, app); !completed) return fail(completed.error());
  Result<ProgressMode> mode = progress_mode(o.talk.progress, o.talk.quiet);
  if (!mode) return fail(mode.error());
  ProgressPrinter printer(*mode);
  Result<BatchSummary> summary = run_batch(o.request, make_control(printer, o.talk));
  if (!summary) return printer.fail(summary.error());
  const int printed = o.talk.json    ? print(batch_json(*summary) + "\n")
                      : o.talk.quiet ? 0
                                     : print(batch_text(*summary));
  if (printed != 0) return printed;
  return summary->failed() == 0 ? 0 : 1;
}

}  // namespace pentimento::cli
