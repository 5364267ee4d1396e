// pentimento verify LOG HASHES: is the replay the one that was recorded?

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "cli/limit_options.h"
#include "cli/progress.h"
#include "cli/range.h"
#include "cli/talk.h"
#include "cli/values.h"
#include "replay/commands/verify.h"

namespace pentimento::cli {

namespace {
constexpr const char* kVerifyAbout =
    "Replay a log and compare the state after each step with what `render --hashes` recorded. "
    "Names\n"
    "the first step, event, fields and tiles that differ. Exit code 1: they differ.\n\n"
    "Examples:\n"
    "  pentimento render session.jsonl --hashes session.hashes.gz\n"
    "  pentimento verify session.jsonl session.hashes.gz\n"
    "  pentimento verify session.jsonl session.hashes.gz -o state-%.h5 --recorded-by "
    "./old/pentimento";

struct VerifyWords {
  VerifyRequest request;
  TalkOptions talk;
  LimitOptions limits;
  std::vector<std::string> set;
  std::string scheme, gravity;
};

void add_options(CLI::App& app, VerifyWords& o) {
  RenderJob& job = o.request.job;
  app.add_option("log", job.log, "the action log")->required()->type_name("");
  app.add_option("hashes", o.request.hashes, "what `render --hashes` wrote")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", o.request.dumps,
                 "dump the states where they part; `%` becomes before, after and recorded")
      ->type_name("FILE.h5");
  app.add_option("--recorded-by", o.request.recorded_by,
                 "the program that recorded, to dump and compare its state, too")
      ->type_name("FILE");
  app.add_option("--from", job.from, "start from a state dump")->type_name("STATE.h5");
  app.add_option("--scheme", o.scheme, "of the fluid")->type_name("conservative|paper");
  app.add_option("--set", o.set, "a parameter of the model; repeatable")
      ->allow_extra_args(false)
      ->type_name("model.NAME=VALUE");
  app.add_option("--gravity", o.gravity, "in place of the log's, m/s^2 (x right, y up, z out)")
      ->type_name("X,Y,Z");
  app.add_flag("--salvage", job.reading.salvage, "replay a log that is cut short in its last line");
  app.add_flag("--allow-outside", job.reading.allow_outside,
               "the log may name files outside its folder");
  o.limits.add_to(app, job.reading.limits);
  app.add_option("--threads", job.threads, "0 = all")->check(in_range(0, 1024))->type_name("N");
}

/// Parses the options that are text into the job.
Result<void> complete(VerifyWords& o) {
  RenderJob& job = o.request.job;
  if (Result<void> limited = o.limits.complete(job.reading.limits); !limited) return limited;
  if (!o.scheme.empty()) job.model.emplace_back("scheme", o.scheme);
  for (const std::string& setting : o.set) {
    Result<std::pair<std::string, std::string>> pair = parse_model_setting(setting);
    if (!pair) return pair.error();
    job.model.push_back(std::move(*pair));
  }
  if (o.gravity.empty()) return {};
  Result<std::array<double, 3>> gravity = parse_vector("--gravity", o.gravity);
  if (!gravity) return gravity.error();
  job.gravity = *gravity;
  return {};
}
}  // namespace

int run_verify(const Arguments& arguments) {
  VerifyWords o;
  CLI::App app(kVerifyAbout, "pentimento verify");
  add_options(app, o);
  o.talk.add_to(app);
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  o.request.job.command = command_line("verify", arguments);
  if (Result<void> completed = complete(o); !completed) return fail(completed.error());
  Result<ProgressMode> mode = progress_mode(o.talk.progress, o.talk.quiet);
  if (!mode) return fail(mode.error());
  ProgressPrinter printer(*mode);
  Result<VerifyReport> report = verify(o.request, make_control(printer, o.talk));
  if (!report) return printer.fail(report.error());
  const int printed = print(o.talk.json ? verify_json(*report) + "\n" : verify_text(*report));
  if (printed != 0) return printed;
  return report->difference ? 1 : 0;
}

}  // namespace pentimento::cli
