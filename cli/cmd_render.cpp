// pentimento render LOG -o OUT: the main job.

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/checkpoint_options.h"
#include "cli/command.h"
#include "cli/film_options.h"
#include "cli/limit_options.h"
#include "cli/picture_options.h"
#include "cli/progress.h"
#include "cli/range.h"
#include "cli/shader_folder.h"
#include "cli/talk.h"
#include "cli/values.h"
#include "formats/log/tables/ranges.h"
#include "replay/commands/dry_run.h"
#include "replay/commands/render.h"

namespace pentimento::cli {

namespace {
constexpr const char* kRenderAbout =
    "Replay a log and write pictures and state.\n\n"
    "Examples:\n"
    "  pentimento render session.jsonl -o picture.png\n"
    "  pentimento render session.jsonl -o poster.png -o poster.exr --print 60x45cm --dpi 300\n"
    "  pentimento render session.jsonl -o frame-%.png --at 10 --at 20 --at mark:glaze\n"
    "  pentimento render session.jsonl -o film.mp4 --length 20s --width 640\n"
    "  pentimento render session.jsonl -o state.h5 --json\n"
    "  cat session.jsonl.zst | pentimento render - -o - > picture.png";

struct RenderOptions {
  RenderJob job;
  PictureOptions picture;
  FilmOptions film;
  CheckpointOptions checkpoint;
  TalkOptions talk;
  LimitOptions limits;
  std::vector<std::string> at, set;
  std::string scheme, gravity, memory_limit, refine;
  bool dry_run = false;
};

void add_replay_options(CLI::App& app, RenderOptions& o) {
  app.add_option("log", o.job.log, "the action log; `-` is standard input")
      ->required()
      ->type_name("");
  app.add_option("--refine", o.refine,
                 "guided: the painting of the log's grid, finer; direct: simulate at the picture's "
                 "size, another painting")
      ->check(CLI::IsMember({"guided", "direct"}).description(""))
      ->type_name("guided|direct");
  app.add_option("--detail", o.job.detail, "fine cells per cell of the log's grid, 1..32")
      ->check(in_range(1, kMostDetail))
      ->type_name("K");
  app.add_option("--sim-scale", o.job.sim_scale,
                 "simulation grid / output size; with --refine direct")
      ->check(in_range(1e-3, 1e3))
      ->type_name("F");
  app.add_option("--at", o.at, "stop at seconds, step:N or mark:NAME; repeatable, `%` in the name")
      ->allow_extra_args(false)
      ->type_name("WHEN");
  app.add_option("--settle", o.job.settle_s, "go on for so many seconds after the end")
      ->check(in_range(0.0, 1e6))
      ->type_name("S");
  app.add_option("--from", o.job.from, "start from a state dump")->type_name("STATE.h5");
  app.add_option("--scheme", o.scheme, "of the fluid")->type_name("conservative|paper");
  app.add_option("--set", o.set, "a parameter of the model; repeatable")
      ->allow_extra_args(false)
      ->type_name("model.NAME=VALUE");
  app.add_option("--gravity", o.gravity, "in place of the log's, m/s^2 (x right, y up, z out)")
      ->type_name("X,Y,Z");
}

void add_limit_options(CLI::App& app, RenderOptions& o) {
  app.add_flag("--salvage", o.job.reading.salvage,
               "replay a log that is cut short in its last line");
  app.add_flag("--allow-outside", o.job.reading.allow_outside,
               "the log may name files outside its folder");
  app.add_option("--memory-limit", o.memory_limit, "refuse a job that needs more (8G)")
      ->type_name("BYTES");
  app.add_option("--scratch", o.job.scratch,
                 "a folder for what does not fit in --memory-limit; its file has no name")
      ->type_name("DIR");
  o.limits.add_to(app, o.job.reading.limits);
  app.add_option("--hashes", o.job.hashes, "write hashes of the state after each step, for verify")
      ->type_name("FILE");
  o.checkpoint.add_to(app);
  app.add_flag("--dry-run", o.dry_run, "tell size, steps, memory, disk and time; do nothing");
}

/// As a log's event of gravity may be.
Result<std::array<double, 3>> parse_gravity(const std::string& text) {
  Result<std::array<double, 3>> gravity = parse_vector("--gravity", text);
  if (!gravity) return gravity;
  const log::Range& range = log::kAccelerationRange;
  for (const double value : *gravity) {
    if (value >= range.min && value <= range.max) continue;
    return Error{ErrorCode::kUsage, fmt::format("--gravity {}: {} is outside {}..{} m/s^2", text,
                                                value, range.min, range.max)};
  }
  return gravity;
}

/// Parses the options that are text into the job.
Result<void> complete(RenderOptions& o) {
  RenderJob& job = o.job;
  if (Result<void> limited = o.limits.complete(job.reading.limits); !limited) return limited;
  if (!o.scheme.empty()) job.model.emplace_back("scheme", o.scheme);
  for (const std::string& setting : o.set) {
    Result<std::pair<std::string, std::string>> pair = parse_model_setting(setting);
    if (!pair) return pair.error();
    job.model.push_back(std::move(*pair));
  }
  for (const std::string& at : o.at) {
    Result<StopPoint> point = parse_stop_point(at);
    if (!point) return point.error();
    job.stops.push_back(std::move(*point));
  }
  if (!o.gravity.empty()) {
    Result<std::array<double, 3>> gravity = parse_gravity(o.gravity);
    if (!gravity) return gravity.error();
    job.gravity = *gravity;
  }
  if (!o.refine.empty()) job.refine = o.refine == "direct" ? Refine::kDirect : Refine::kGuided;
  if (!o.memory_limit.empty()) {
    Result<std::int64_t> bytes = parse_bytes("--memory-limit", o.memory_limit);
    if (!bytes) return bytes.error();
    job.max_memory = *bytes;
  }
  Result<CheckpointChoice> checkpoint = o.checkpoint.choice();
  if (!checkpoint) return checkpoint.error();
  job.checkpoint = std::move(*checkpoint);
  Result<PictureChoice> picture = o.picture.picture();
  if (!picture) return picture.error();
  job.picture = std::move(*picture);
  Result<FilmChoice> film = o.film.choice();
  if (!film) return film.error();
  job.film = *film;
  job.picture.frames_per_second = film->frames_per_second;
  Result<LightChoice> light = o.picture.lighting();
  if (!light) return light.error();
  job.light = std::move(*light);
  job.size = o.picture.size();
  job.threads = o.picture.threads;
  if (o.dry_run || (!job.hashes.empty() && job.picture.outputs.empty())) return {};
  return check_outputs(job.picture.outputs, o.talk.json);
}

int run(const RenderOptions& o, ProgressPrinter& printer) {
  const Control control = make_control(printer, o.talk);
  if (o.dry_run) {
    Result<JobEstimate> estimate = dry_run(o.job, control);
    if (!estimate) return printer.fail(estimate.error());
    return print(o.talk.json ? estimate_json(*estimate) + "\n" : estimate_text(*estimate));
  }
  Result<JobReport> done = render(o.job, control);
  if (!done) return printer.fail(done.error());
  return report(*done, o.talk, printer);
}
}  // namespace

int run_render(const Arguments& arguments) {
  RenderOptions o;
  CLI::App app(kRenderAbout, "pentimento render");
  add_replay_options(app, o);
  o.picture.add_to(app);
  o.film.add_to(app);
  add_limit_options(app, o);
  o.talk.add_to(app);
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  o.job.command = command_line("render", arguments);
  if (Result<void> completed = complete(o); !completed) return fail(completed.error());
  Result<ProgressMode> mode = progress_mode(o.talk.progress, o.talk.quiet);
  if (!mode) return fail(mode.error());
  ProgressPrinter printer(*mode);
  use_shader_folder();
  return run(o, printer);
}

}  // namespace pentimento::cli
