#include "replay/commands/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "formats/io/utf8.h"
#include "formats/log/stream/line_source.h"
#include "replay/commands/render.h"
#include "replay/compare/compare.h"
#include "replay/job/step_clock.h"
#include "replay/output/output_claim.h"
#include "replay/play/player.h"
#include "replay/process/child.h"
#include "replay/session/log_session.h"

namespace pentimento {

namespace {
using nlohmann::json;
constexpr std::size_t kMostTilesTold = 5;
constexpr double kMostReplaySeconds = 1e6;  // of the other program

/// Replays the session to its end, or to the first difference.
Result<void> replay(LogSession& session, HashReader& recorded, const Threads& threads,
                    const Control& control, VerifyReport& report) {
  Result<std::unique_ptr<Simulation>> simulation = make_simulation(session, threads);
  if (!simulation) return simulation.error();
  HashChecker checker(session.grid, (*simulation)->model().sleep_tile_m, threads, recorded);
  LightingTrack lighting(session.start ? std::move(session.start->lighting) : default_lighting(),
                         session.reader->header().steps_per_second);
  Timeline timeline(*session.reader, {session.plan.undo, session.brushes, session.plan.stepped,
                                      last_stroke_id((*simulation)->state()) + 1});
  Hand hand(**simulation, hand_input(session));
  Player player(
      {timeline, **simulation, hand, lighting, session.files, control, session.steps, &checker});
  Result<void> played = player.play_all(session.plan.steps);
  if (played) played = checker.finish();
  report.steps = checker.steps();
  report.difference = checker.difference();
  if (!played && !report.difference) return played;
  return {};
}

Result<void> check_origin(const HashHeader& recorded, const LogSession& session,
                          const VerifyRequest& request) {
  if (recorded.log_sha256 != session.plan.sha256)
    return Error{ErrorCode::kBadInput, fmt::format("{}: recorded from another log than {}",
                                                   request.hashes, request.job.log)};
  if (recorded.width != session.grid.width || recorded.height != session.grid.height)
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: recorded on {} x {} cells, but {} is on {} x {}", request.hashes,
                             recorded.width, recorded.height, request.job.log, session.grid.width,
                             session.grid.height)};
  return {};
}

/// The type of the event in a line of the log; empty if there is none.
std::string event_in(const std::string& log, std::int64_t line_number) {
  Result<std::unique_ptr<log::ByteSource>> bytes = log::ByteSource::open(log);
  if (log == "-" || !bytes) return {};
  log::ReaderOptions options;
  options.limits.max_line_bytes = std::int64_t{1} << 30;
  log::LineSource lines(std::move(*bytes), options);
  while (true) {
    const Result<std::optional<log::Line>> line = lines.next();
    if (!line || !*line || (*line)->number > line_number) return {};
    if ((*line)->number < line_number) continue;
    const json event = json::parse((*line)->text, nullptr, false);
    return event.is_object() ? event.value("type", "") : "";
  }
}

std::string named(const std::string& pattern, const char* what) {
  std::string name = pattern;
  return name.replace(name.find('%'), 1, what);
}

/// Dumps the state after `step` steps.
Result<void> write_dump(const VerifyRequest& request, std::int64_t step, const char* what,
                        const Control& control, VerifyReport& report) {
  RenderJob job = request.job;
  job.picture = {};
  job.picture.outputs = {named(request.dumps, what)};
  Result<StopPoint> stop = parse_stop_point("step:" + std::to_string(step));
  if (!stop) return stop.error();
  job.stops = {*stop};
  Result<JobReport> done = render(job, control);
  if (!done) return done.error();
  report.dumps.push_back(job.picture.outputs.front());
  return {};
}

/// Has the program that recorded dump its state, and compares that with `after`.
Result<void> ask_recorder(const VerifyRequest& request, const std::vector<std::string>& options,
                          const Control& control, VerifyReport& report) {
  const std::string dump = named(request.dumps, "recorded");
  ChildSpec spec;
  spec.program = request.recorded_by;
  spec.folder = ".";
  spec.output_file = spec.message_file = "/dev/null";
  spec.timeout_s = kMostReplaySeconds;
  spec.words = {"render",
                request.job.log,
                "-o",
                dump,
                "--quiet",
                "--at",
                "step:" + std::to_string(report.difference->step)};
  spec.words.insert(spec.words.end(), options.begin(), options.end());
  Result<std::unique_ptr<Child>> child = Child::start(spec);
  if (!child) return child.error();
  while (!(*child)->has_ended()) {
    if (Result<void> go = control.go_on(); !go) return go;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if ((*child)->done().end != ChildEnd::kExit || (*child)->done().code != 0)
    return Error{ErrorCode::kIo,
                 fmt::format("{} could not render {}", request.recorded_by, request.job.log)};
  report.dumps.push_back(dump);
  const Result<Comparison> comparison =
      compare_files(dump, named(request.dumps, "after"), {}, request.job.threads);
  if (!comparison) return comparison.error();
  report.comparison = comparison_text(*comparison);
  return {};
}

/// What changes the replay, as words for `render`.
std::vector<std::string> replay_words(const RenderJob& job) {
  std::vector<std::string> words;
  for (const auto& [name, value] : job.model) {
    words.emplace_back("--set");
    words.push_back("model." + name + "=" + value);
  }
  if (!job.from.empty()) words.insert(words.end(), {"--from", job.from});
  if (job.gravity) words.push_back(fmt::format("--gravity={}", fmt::join(*job.gravity, ",")));
  return words;
}

Result<void> explain(const VerifyRequest& request, const Control& control, VerifyReport& report) {
  const HashDifference& difference = *report.difference;
  report.event = event_in(request.job.log, difference.line);
  if (request.dumps.empty()) return {};
  if (difference.last_equal_step > 0) {
    if (Result<void> wrote =
            write_dump(request, difference.last_equal_step, "before", control, report);
        !wrote)
      return wrote;
  }
  if (Result<void> wrote = write_dump(request, difference.step, "after", control, report); !wrote)
    return wrote;
  return request.recorded_by.empty()
             ? Result<void>()
             : ask_recorder(request, replay_words(request.job), control, report);
}

Result<OutputClaim> claim_dumps(const VerifyRequest& request, const LogFiles& named_files) {
  if (request.dumps.empty()) return OutputClaim();
  std::vector<InputFile> inputs = files_read_by(request.job, named_files);
  inputs.push_back({request.hashes, "the hashes"});
  std::vector<std::string> dumps;
  for (const char* part : {"before", "after", "recorded"})
    dumps.push_back(named(request.dumps, part));
  return OutputClaim::take({request.dumps}, dumps, inputs);
}
}  // namespace

Result<VerifyReport> verify(const VerifyRequest& request, const Control& control) {
  const bool has_mark = request.dumps.find('%') != std::string::npos;
  if (!request.dumps.empty() && (!has_mark || !request.dumps.ends_with(".h5")))
    return Error{ErrorCode::kUsage, "-o " + request.dumps + ": must be a name with `%` and .h5"};
  if (!request.recorded_by.empty() && request.dumps.empty())
    return Error{ErrorCode::kUsage, "--recorded-by needs -o"};
  Result<std::unique_ptr<HashReader>> recorded = HashReader::open(request.hashes);
  if (!recorded) return recorded.error();
  Result<LogSession> session = open_session(request.job, control);
  if (!session) return session.error();
  const Result<OutputClaim> claim = claim_dumps(request, session->files);
  if (!claim) return claim.error();
  const HashHeader& header = (*recorded)->header();
  if (Result<void> fits = check_origin(header, *session, request); !fits) return fits.error();
  VerifyReport report;
  report.grid = session->grid;
  report.recorded_command = header.command;
  report.recorded_software = header.software;
  const StepClock clock(session->reader->header().steps_per_second);
  const Threads threads(request.job.threads);
  if (Result<void> replayed = replay(*session, **recorded, threads, control, report); !replayed)
    return replayed.error();
  if (!report.difference) return report;
  report.time_s = clock.seconds(report.difference->step);
  if (Result<void> explained = explain(request, control, report); !explained)
    return explained.error();
  return report;
}

std::string verify_text(const VerifyReport& report) {
  if (!report.difference) return fmt::format("equal: {} steps\n", report.steps);
  const HashDifference& d = *report.difference;
  std::string text = fmt::format(
      "different from step {} on ({:.3f} s), after line {} of the log{}\n", d.step, report.time_s,
      d.line, report.event.empty() ? "" : " (" + one_line(report.event) + ")");
  if (!d.note.empty()) text += d.note + "\n";
  if (!d.fields.empty()) text += fmt::format("fields: {}\n", fmt::join(d.fields, ", "));
  for (std::size_t i = 0; i < std::min(d.tiles.size(), kMostTilesTold); ++i)
    text += fmt::format("tile: cells {}..{} across, {}..{} down\n", d.tiles[i].x0,
                        d.tiles[i].x1 - 1, d.tiles[i].y0, d.tiles[i].y1 - 1);
  if (d.tiles.size() > kMostTilesTold)
    text += fmt::format("and {} more tiles\n", d.tiles.size() - kMostTilesTold);
  text += fmt::format("recorded by {}\n  {}\n", report.recorded_software, report.recorded_command);
  for (const std::string& dump : report.dumps) text += "written: " + dump + "\n";
  return text + report.comparison;
}

std::string verify_json(const VerifyReport& report) {
  json out = {{"equal", !report.difference},
              {"steps", report.steps},
              {"recorded_by", report.recorded_software},
              {"recorded_command", report.recorded_command},
              {"outputs", report.dumps}};
  if (report.difference) {
    const HashDifference& d = *report.difference;
    json tiles = json::array();
    for (const CellBox& box : d.tiles) tiles.push_back({box.x0, box.y0, box.x1, box.y1});
    out["difference"] = {{"step", d.step},
                         {"time_s", report.time_s},
                         {"line", d.line},
                         {"event", report.event},
                         {"last_equal_step", d.last_equal_step},
                         {"fields", d.fields},
                         {"tiles", tiles},
                         {"note", d.note}};
  }
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace pentimento
