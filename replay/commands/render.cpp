#include "replay/commands/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/float_environment.h"
#include "core/base/thread_count.h"
#include "replay/checkpoint/checkpointer.h"
#include "replay/estimate/disk_check.h"
#include "replay/estimate/memory_estimate.h"
#include "replay/film/even_sides.h"
#include "replay/film/film_plan.h"
#include "replay/hashes/hash_recorder.h"
#include "replay/job/build_info.h"
#include "replay/job/step_clock.h"
#include "replay/job/stopwatch.h"
#include "replay/output/canvas_view.h"
#include "replay/output/effective.h"
#include "replay/output/output_claim.h"
#include "replay/output/output_plan.h"
#include "replay/output/output_set.h"
#include "replay/play/copies.h"
#include "replay/play/light_override.h"
#include "replay/play/player.h"
#include "replay/session/log_session.h"

namespace pentimento {

namespace {

Lighting first_lighting(LogSession& session) {
  Lighting lighting = session.start ? std::move(session.start->lighting) : default_lighting();
  develop(session.reader->header().picture, lighting);
  return lighting;
}

/// One replay, from the first step to the closing report.
class Replay {
 public:
  /// `film` nullptr: the job makes none.
  Replay(const RenderJob& job, const JobNeeds& needs, LogSession& session, const FilmPlan* film,
         const Control& control, Stopwatch& watch)
      : job_(job),
        needs_(needs),
        session_(session),
        film_(film),
        control_(control),
        watch_(watch),
        threads_(job.threads),
        settings_{job.picture,
                  session.size,
                  threads_.count(),
                  control,
                  files_read_by(job, session.files),
                  job.checkpoint.folder},
        outputs_(settings_, watch),
        lighting_(first_lighting(session), session.reader->header().steps_per_second) {}

  Result<JobReport> run();

 private:
  Result<void> begin();
  Result<void> claim_outputs();
  Result<void> begin_hashes();
  Result<void> begin_checkpoint();
  Result<void> play();
  Result<void> pass_stops();
  Result<void> play_to_stop(std::size_t stop);
  Result<void> write(const std::vector<PlannedOutput>& files);
  Result<void> hash(const CanvasView& view);
  Origin origin(const Lighting& lighting) const;
  StateDump dump_of(const CanvasView& view, Lighting lighting, const Origin& from) const;
  double time_s() const;
  void conclude();

  const RenderJob& job_;
  const JobNeeds& needs_;
  LogSession& session_;
  const FilmPlan* film_;
  const Control& control_;
  Stopwatch& watch_;
  Threads threads_;
  OutputSettings settings_;
  OutputClaim claim_;
  OutputSet outputs_;
  LightingTrack lighting_;
  LightOverride light_;
  std::map<std::string, std::string> files_of_options_;  // option, SHA-256
  std::vector<std::vector<PlannedOutput>> files_;        // for each stop
  std::int64_t first_step_ = 0;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<ReplayDetail> fine_;  // empty at detail 1
  std::unique_ptr<Timeline> timeline_;
  std::unique_ptr<Hand> hand_;
  std::unique_ptr<HashWriter> hash_file_;  // empty without --hashes
  std::unique_ptr<HashRecorder> hashes_;
  std::unique_ptr<Checkpointer> checkpoint_;  // empty without --checkpoint
  std::unique_ptr<Player> player_;
  JobReport report_;
};

bool any_state(const std::vector<PlannedOutput>& files) {
  return std::any_of(files.begin(), files.end(),
                     [](const PlannedOutput& f) { return f.kind == OutputKind::kState; });
}

Result<JobReport> Replay::run() {
  // Everything is made before the first step, ...
  if (Result<void> begun = begin(); !begun) return begun.error();
  // ... the log is replayed from stop to stop, ...
  if (Result<void> played = play(); !played) return played.error();
  // ... and only then do the finished files get their names.
  watch_.start("publish");
  if (hash_file_) {
    if (Result<Published> whole = hash_file_->complete(); !whole) return whole.error();
  }
  Result<std::vector<WrittenFile>> written = outputs_.publish();
  if (!written) return written.error();
  report_.outputs = std::move(*written);
  if (hash_file_) {
    Result<Published> published = hash_file_->publish();
    if (!published) return published.error();
    report_.outputs.push_back({job_.hashes, 0, 0, published->sha256, {}});
  }
  if (checkpoint_) report_.checkpoint = checkpoint_->finish();
  conclude();
  return std::move(report_);
}

/// Says why a direct simulation gives another painting than the log's. Empty if it runs on the
/// log's grid.
std::string other_painting(const LogSession& session) {
  const CanvasGeometry &a = session.grid, &b = session.canvas;
  if (a.width == b.width && a.height == b.height) return {};
  return fmt::format("another than the log's: simulated on {} x {} cells, not on {} x {}", a.width,
                     a.height, b.width, b.height);
}

Result<void> Replay::begin() {
  // What is to be written, at which stop.
  report_.other_painting = other_painting(session_);
  Result<std::vector<std::vector<PlannedOutput>>> files =
      film_ ? film_->files : plan_outputs(job_.picture.outputs, job_.stops);
  if (!files) return files.error();
  files_ = std::move(*files);
  if (Result<void> claimed = claim_outputs(); !claimed) return claimed;
  watch_.start("prepare");
  if (const int wanted = wanted_threads(job_.threads); threads_.count() < wanted) {
    control_.warning(fmt::format("the machine gives {} of {} threads; the result is the same",
                                 threads_.count(), wanted));
  }
  if (!job_.checkpoint.folder.empty()) {
    Result<std::unique_ptr<Checkpointer>> opened = Checkpointer::open(job_.checkpoint, control_);
    if (!opened) return opened.error();
    checkpoint_ = std::move(*opened);
  }
  // The light that the options ask for.
  Result<LightOverride> light = LightOverride::make(job_.light);
  if (!light) return light.error();
  light_ = std::move(*light);
  for (const auto& [option, file] :
       {std::pair<const char*, const std::string&>{"--from", job_.from},
        {"--environment", job_.light.environment}}) {
    if (Result<void> added = add_file_of_option(option, file, files_of_options_); !added)
      return added;
  }
  // The guide: the simulation on the log's grid, fresh or as a dump left it.
  Result<std::unique_ptr<Simulation>> simulation = make_simulation(session_, threads_);
  if (!simulation) return simulation.error();
  simulation_ = std::move(*simulation);
  first_step_ = simulation_->state().step;
  if (session_.detail > 1) {
    // The detail canvas, which follows the guide.
    ReplayDetailSetup setup{session_.detail, job_.scratch, 0, {}};
    if (!job_.scratch.empty()) setup.resident_bytes = needs_.resident_bytes;
    setup.start = std::exchange(session_.detail_start, {});
    if (checkpoint_ && checkpoint_->has_slots()) setup.start.reset();
    Result<std::unique_ptr<ReplayDetail>> fine = ReplayDetail::follow(
        *simulation_, setup, session_.reader->header().paper, session_.files, threads_);
    if (!fine) return fine.error();
    fine_ = std::move(*fine);
  }
  // The log's events in time, the hand that does them, and the player who lets time pass.
  const TimelineInput input{session_.plan.undo, session_.brushes, session_.plan.stepped,
                            last_stroke_id(simulation_->state()) + 1};
  timeline_ = std::make_unique<Timeline>(*session_.reader, input);
  hand_ = std::make_unique<Hand>(*simulation_,
                                 hand_input(session_, fine_ ? &fine_->substrate() : nullptr));
  if (Result<void> begun = begin_hashes(); !begun) return begun;
  player_ = std::make_unique<Player>(PlayerInput{*timeline_, *simulation_, *hand_, lighting_,
                                                 session_.files, control_, session_.steps,
                                                 hashes_.get(), checkpoint_.get()});
  return begin_checkpoint();
}

/// Goes on from a slot, if there is one.
Result<void> Replay::begin_checkpoint() {
  if (!checkpoint_) return {};
  watch_.start("resume");
  return checkpoint_->begin({*simulation_, fine_.get(), *player_, outputs_, files_},
                            binding_of(job_, session_, files_of_options_));
}

Result<void> Replay::claim_outputs() {
  std::vector<std::string> patterns = job_.picture.outputs;
  std::vector<std::string> written = paths_of(files_);
  if (!job_.hashes.empty()) {
    patterns.push_back(job_.hashes);
    written.push_back(job_.hashes);
  }
  Result<OutputClaim> claim = OutputClaim::take(patterns, written, settings_.inputs);
  if (!claim) return claim.error();
  claim_ = std::move(*claim);
  return {};
}

Result<void> Replay::begin_hashes() {
  if (job_.hashes.empty()) return {};
  const float tile_m = simulation_->model().sleep_tile_m;
  const FieldHashes tiles(session_.grid, tile_m);
  const HashHeader header{session_.plan.sha256, software(),           job_.command,
                          session_.grid.width,  session_.grid.height, tiles.tile_width(),
                          tiles.tile_height()};
  Result<std::unique_ptr<HashWriter>> file =
      HashWriter::create(job_.hashes, header, job_.picture.no_clobber);
  if (!file) return file.error();
  hash_file_ = std::move(*file);
  hashes_ = std::make_unique<HashRecorder>(session_.grid, tile_m, threads_, *hash_file_);
  return {};
}

/// Plays all. What is interrupted is saved, if the job is to be saved.
Result<void> Replay::play() {
  Result<void> passed = pass_stops();
  if (passed) passed = control_.go_on();
  if (passed || !checkpoint_ || passed.error().code != ErrorCode::kInterrupted) return passed;
  return checkpoint_->interrupted();
}

/// Visits the stops in the order of time, whatever order the options gave.
Result<void> Replay::pass_stops() {
  std::vector<std::size_t> order(files_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<std::int64_t>& stops = session_.plan.stops;
  if (!stops.empty()) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return stops[a] < stops[b]; });
  }
  const std::size_t first = checkpoint_ ? checkpoint_->stops_done() : 0;
  for (std::size_t i = first; i < order.size(); ++i) {
    watch_.start("simulate");
    if (Result<void> played = play_to_stop(order[i]); !played) return played;
    const bool last = i + 1 == order.size();
    if (checkpoint_) checkpoint_->before_outputs(last);
    if (Result<void> written = write(files_[order[i]]); !written) return written;
    if (checkpoint_ && !last) checkpoint_->stop_done();  // of the last one the report needs all
  }
  return {};
}

Result<void> Replay::play_to_stop(std::size_t stop) {
  const std::vector<std::int64_t>& stops = session_.plan.stops;
  Result<void> played =
      stops.empty() ? player_->play_all(session_.plan.steps) : player_->play_to(stops[stop]);
  if (!played) return played;
  // The paint comes to rest, if asked.
  if (Result<void> rested = player_->settle(job_.settle_s ? session_.steps : player_->steps());
      !rested)
    return rested;
  return fine_ ? fine_->problem() : Result<void>();
}

double Replay::time_s() const {
  return StepClock(session_.reader->header().steps_per_second).seconds(simulation_->state().step);
}

Origin Replay::origin(const Lighting& lighting) const {
  Origin origin;
  origin.log_sha256 = session_.plan.sha256;
  origin.files = session_.files.hashes();
  origin.files.insert(files_of_options_.begin(), files_of_options_.end());
  origin.state_sha256 = report_.state_sha256;
  origin.guide_sha256 = report_.guide_sha256;
  origin.model = simulation_->model();
  origin.grid = session_.grid;
  origin.detail = session_.detail;
  origin.other_painting = report_.other_painting;
  origin.steps_per_second = session_.reader->header().steps_per_second;
  origin.step = simulation_->state().step;
  origin.time_s = time_s();
  origin.lighting = clone_lighting(lighting);
  origin.command = job_.command;
  return origin;
}

Result<void> Replay::hash(const CanvasView& view) {
  report_.guide_sha256 = state_sha256(simulation_->state(), control_.cancelled);
  report_.state_sha256 = view.detail > 1 ? detail_sha256(*view.canvas, threads_, control_.cancelled)
                                         : report_.guide_sha256;
  return control_.go_on();
}

Result<void> Replay::write(const std::vector<PlannedOutput>& files) {
  watch_.start("hash");
  // The hashes that every output carries. A film carries none.
  const CanvasView view = make_canvas_view(*simulation_, fine_.get(), session_.detail);
  const bool only_film = &files != &files_.back() &&
                         std::all_of(files.begin(), files.end(), [](const PlannedOutput& output) {
                           return output.kind == OutputKind::kVideo;
                         });
  if (!only_film)
    if (Result<void> hashed = hash(view); !hashed) return hashed;
  // The light at this moment: the log's, then what the options change, then lamps fixed in the
  // room.
  if (Result<void> looked = lighting_.look(player_->steps()); !looked) return looked;
  Lighting lighting = clone_lighting(lighting_.lighting());
  light_.apply(lighting);
  const log::Gravity gravity = session_.gravity.value_or(lighting_.gravity());
  for (Lamp& lamp : lighting.lamps) fix_lamp(lamp, gravity);
  // Pictures, then dumps.
  const StateSource guide(simulation_->state());
  const Scene scene{*view.canvas, simulation_->basis(), simulation_->model(), lighting,
                    view.detail > 1 ? &guide : nullptr};
  const Origin from = origin(lighting);
  if (Result<void> shaded = outputs_.add_pictures(files, scene, from); !shaded) return shaded;
  if (!any_state(files)) return {};
  return outputs_.add_states(files, dump_of(view, std::move(lighting), from), from);
}

StateDump Replay::dump_of(const CanvasView& view, Lighting lighting, const Origin& from) const {
  StateDump dump;
  dump.state = clone_state(simulation_->state());
  dump.detail = view.detail;
  if (view.detail > 1) {
    dump.fine = view.canvas;
    dump.checkpoint = fine_->checkpoint();
  }
  dump.model = simulation_->model();
  dump.basis = simulation_->basis();
  dump.palette = session_.palette.pigments();
  dump.lighting = std::move(lighting);
  dump.steps_per_second = from.steps_per_second;
  dump.time_s = from.time_s;
  dump.log_sha256 = from.log_sha256;
  dump.state_sha256 = from.state_sha256;
  dump.guide_sha256 = from.guide_sha256;
  return dump;
}

void Replay::conclude() {
  watch_.stop();
  report_.steps = player_->steps();
  report_.steps_computed = player_->steps_computed();
  report_.simulated_s =
      StepClock(session_.reader->header().steps_per_second).seconds(report_.steps);
  report_.detail = session_.detail;
  report_.log_sha256 = session_.plan.sha256;
  report_.threads = threads_.count();
  report_.paint = paint_lines(*simulation_);
  report_.fluid = simulation_->statistics();
  if (fine_) report_.lock = fine_->follower().lock_statistics();
  if (film_) report_.frame_steps = film_->steps;
  report_.phases = watch_.phases();
  report_.wall_s = watch_.total_s();
  report_.peak_memory_bytes = peak_memory_bytes();
}

/// The survey of a session that fits in memory: of one that would fit if it were painted all over,
/// and has no detail canvas, an empty one.
Result<PaintSurvey> fitting_survey(const RenderJob& job, LogSession& session,
                                   const Control& control) {
  Result<PaintSurvey> survey = PaintSurvey{};
  const bool fits_full = session.detail == 1 && check_memory(job, session, *survey);
  if (session.detail > 1 || (!fits_full && memory_follows_paint(session)))
    survey = survey_paint(session, DetailCost(), control);
  if (!survey) return survey.error();
  if (Result<void> fits = check_memory(job, session, *survey); !fits) return fits.error();
  return survey;
}

}  // namespace

Result<JobReport> render(const RenderJob& job, const Control& control) {
  const PlainArithmetic plain;
  Stopwatch watch;
  watch.start("read");
  if (job.settle_s && job.stops.size() > 1) {
    return Error{ErrorCode::kUsage, "--settle goes with at most one --at"};
  }
  // Reads the log once to check it, and opens what it names.
  Result<LogSession> session = open_session(job, control);
  if (!session) return session.error();
  if (!job.checkpoint.folder.empty() && !job.hashes.empty()) {
    return Error{ErrorCode::kUsage,
                 "--checkpoint does not go with --hashes: a file of hashes begins with its log"};
  }
  if (Result<void> even = check_even_sides(job.picture, session->size, session->canvas); !even)
    return even.error();
  // Refuses what would not fit in memory before anything is computed.
  Result<PaintSurvey> survey = fitting_survey(job, *session, control);
  if (!survey) return survey.error();
  const JobNeeds needs = job_needs(job, *session, *survey);
  if (Result<void> fits = check_disk(disk_uses(job, needs)); !fits) return fits.error();
  // The frames of a film are stops of the replay.
  std::optional<FilmPlan> film;
  if (makes_film(job)) {
    Result<FilmPlan> plan =
        plan_film(job, *session->reader, session->plan.stepped, session->plan.steps, control);
    if (!plan) return plan.error();
    film = std::move(*plan);
    session->plan.stops = film->steps;
  }
  Replay replay(job, needs, *session, film ? &*film : nullptr, control, watch);
  return replay.run();
}

}  // namespace pentimento
