#include "replay/session/log_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "formats/log/tables/model_fields.h"
#include "replay/job/step_clock.h"
#include "replay/paper/paper_relief.h"
#include "replay/play/changed_canvas.h"
#include "replay/play/channel_change.h"
#include "replay/session/header_files.h"
#include "replay/session/simulation_setup.h"

namespace pentimento {

namespace {
Result<Model> effective_model(const log::Header& header, const RenderJob& job) {
  Model model = header.model;
  for (const auto& [name, value] : job.model) {
    if (Result<void> set = log::set_model_text(model, name, value); !set) return set.error();
  }
  const std::string problem = log::model_problem(model);
  if (!problem.empty()) return Error{ErrorCode::kUsage, "--set model." + problem};
  return model;
}

bool same_model(const Model& a, const Model& b) {
  const auto fields = log::model_fields();
  return std::all_of(fields.begin(), fields.end(), [&](const log::ModelField& field) {
    return log::get_model_value(field, a) == log::get_model_value(field, b);
  });
}

/// Paint that rested in the dump's model may not rest in the log's, so everything wakes.
void wake_if_changed(const log::Header& header, const Model& model, StateDump& dump) {
  if (!same_model(model, dump.model) || header.steps_per_second != dump.steps_per_second)
    dump.state.sleep.clear();
}

/// A replay cannot go on from a canvas with other bands or another interface.
Result<void> check_optics(const std::string& path, const LogSession& session,
                          const StateDump& dump) {
  const auto optics = [](const Model& m, const std::vector<double>& wavelength_nm) {
    const std::string bands = fmt::format("bands at {} nm", fmt::join(wavelength_nm, " "));
    return fmt::format("{}, saunderson_k1 {}, saunderson_k2 {}",
                       wavelength_nm.empty() ? "rgb" : bands, m.saunderson_k1, m.saunderson_k2);
  };
  const std::string wanted = optics(session.model, session.maker.wavelength_nm());
  const std::string found = optics(dump.model, dump.basis.wavelength_nm);
  if (wanted == found) return {};
  return Error{ErrorCode::kBadInput,
               fmt::format("{}: its optics are {}, the log's {}", path, found, wanted)};
}

/// The log's planes and palette continue those of the dump.
Result<void> start_from(const RenderJob& job, LogSession& session, const Control& control) {
  const std::string& path = job.from;
  Result<StateDump> dump = read_state(path, {job.threads, control.cancelled});
  if (!dump) return dump.error();
  const CanvasGeometry& canvas = dump->state.geometry;
  if (canvas.width_m != session.canvas.width_m || canvas.height_m != session.canvas.height_m) {
    return Error{
        ErrorCode::kBadInput,
        fmt::format("{}: its canvas is {} x {} m, the log's {} x {} m", path, canvas.width_m,
                    canvas.height_m, session.canvas.width_m, session.canvas.height_m)};
  }
  if (Result<void> same = check_optics(path, session, *dump); !same) return same;
  Result<std::vector<Pigment>> joined =
      join_palettes(dump->palette, session.plan.palette.pigments());
  if (!joined) return Error{joined.error().code, path + ": " + joined.error().message};
  session.palette = Palette::of(std::move(*joined), session.maker);
  session.first_color = session.palette.find(session.plan.palette.pigments().front().name);
  session.basis = channels_after(dump->basis, session.palette.pigments());
  dump->state = change_channels(std::move(dump->state), dump->basis, session.basis);
  session.canvas = session.grid = canvas;
  session.model.layers = dump->state.layers;
  wake_if_changed(session.reader->header(), session.model, *dump);
  session.start = std::move(*dump);
  return {};
}

/// How the size asked for is reached. Errors: kUsage for options that exclude each other.
Result<void> choose_refinement(const RenderJob& job, LogSession& session, const Control& control) {
  session.refine = job.refine.value_or(job.sim_scale ? Refine::kDirect : Refine::kGuided);
  if (session.refine == Refine::kDirect) {
    if (!job.detail) return {};
    return Error{ErrorCode::kUsage, "--detail is for --refine guided: direct has one grid"};
  }
  if (job.sim_scale) {
    return Error{ErrorCode::kUsage,
                 "--sim-scale is for --refine direct: guided simulates on the log's grid"};
  }
  session.detail = job.detail.value_or(detail_for(session.size, session.canvas));
  const int wanted = detail_wanted(session.size, session.canvas);
  if (!job.detail && wanted > kMostDetail)
    control.warning(
        fmt::format("the picture wants {} fine cells per cell of the grid; {} is the "
                    "most, and the picture is enlarged from them",
                    wanted, kMostDetail));
  if (session.detail > 1 && session.model.scheme == SchemeKind::kPaper) {
    return Error{ErrorCode::kUsage,
                 "scheme paper has no detail canvas: a larger picture of it needs --refine direct"};
  }
  return {};
}

CanvasGeometry simulation_grid(const OutputSize& size, const RenderJob& job,
                               const CanvasGeometry& canvas) {
  const double scale = job.sim_scale.value_or(1);
  CanvasGeometry grid = canvas;
  grid.width = std::max(1, static_cast<int>(size.width * scale + 0.5));
  grid.height = std::max(1, static_cast<int>(size.height * scale + 0.5));
  return grid;
}

std::int64_t steps_to_simulate(const LogPlan& plan, const RenderJob& job, double steps_per_second) {
  std::int64_t steps = plan.steps;
  if (!plan.stops.empty()) steps = *std::max_element(plan.stops.begin(), plan.stops.end());
  if (!job.settle_s) return steps;
  const auto settle_us = static_cast<std::int64_t>(*job.settle_s * 1e6 + 0.5);
  return steps + StepClock(steps_per_second).steps_in(settle_us);
}

/// Goes on with the dump's detail canvas if it is as fine as this one. Otherwise says what becomes
/// of it.
void choose_detail_start(const RenderJob& job, LogSession& session, const Control& control) {
  if (!session.start) return;
  StateDump& dump = *session.start;
  const std::shared_ptr<const CanvasSource> fine = std::move(dump.fine);
  const int k = session.detail;
  if (fine && dump.checkpoint && dump.detail == k) {
    session.detail_start = {change_channels(fine, dump.basis, session.basis),
                            change_channels(std::move(*dump.checkpoint), dump, session.basis)};
    return;
  }
  const auto tell = [&](const std::string& why) { control.warning(job.from + ": " + why); };
  if (k == 1 && fine) {
    tell(
        fmt::format("its canvas is {} times finer than its guide, which alone goes on without "
                    "--detail {}",
                    dump.detail, dump.detail));
  } else if (k > 1) {
    tell(fmt::format("{}; the detail canvas is made anew from the guide",
                     dump.detail == k ? "its detail canvas has no /detail to go on from"
                     : fine
                         ? fmt::format("its canvas is {} times finer than its guide, this one {}",
                                       dump.detail, k)
                         : "it has no detail canvas"));
  }
}

/// The folder of --scratch must be there, whether the job will need it or not.
Result<void> check_scratch(const std::string& folder) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return {};
  return Error{ErrorCode::kIo, fmt::format("--scratch {}: {}", folder,
                                           error ? error.message() : "is not a folder")};
}

void tell_oddities(const LogSession& session, const Control& control) {
  if (!session.plan.salvaged.empty()) control.warning(session.plan.salvaged);
  if (session.plan.undo.idle() > 0) {
    control.warning(fmt::format("{} undo or redo events had nothing to act on and were ignored",
                                session.plan.undo.idle()));
  }
  if (session.reader->header().edge_open) {
    control.warning("canvas.edge \"open\" is simulated as closed: paint does not drip off");
  }
}
}  // namespace

Result<LogSession> open_session(const RenderJob& job, const Control& control) {
  LogSession session;
  if (Result<void> scratch = check_scratch(job.scratch); !scratch) return scratch.error();
  log::ReaderOptions reading = job.reading;
  reading.cancelled = control.cancelled;
  Result<std::unique_ptr<log::Reader>> reader = log::Reader::open(job.log, reading);
  if (!reader) return reader.error();
  session.reader = std::move(*reader);
  session.files = LogFiles(job.log, job.reading.allow_outside);
  const log::Header& header = session.reader->header();
  session.canvas = {header.grid_width, header.grid_height, header.canvas_width_m,
                    header.canvas_height_m};
  Result<Model> model = effective_model(header, job);
  if (!model) return model.error();
  session.model = *model;
  if (job.gravity) session.gravity = {(*job.gravity)[0], (*job.gravity)[1], (*job.gravity)[2]};
  Result<BrushTable> brushes = open_header_files(header, session.files);
  if (!brushes) return brushes.error();
  session.brushes = std::move(*brushes);
  control.report({"read", 0, 0});
  session.maker = PaintMaker(session.model);
  StampBudget budget(header, session.brushes, job.reading.limits);
  Result<LogPlan> plan =
      plan_log(*session.reader, session.files, job.stops, session.maker, control, &budget);
  if (!plan) return plan.error();
  session.plan = std::move(*plan);
  session.palette = session.plan.palette;
  session.basis = make_channels(session.palette.pigments(), session.maker.wavelength_nm());
  if (!job.from.empty()) {
    if (Result<void> started = start_from(job, session, control); !started) return started.error();
  }
  Result<OutputSize> size = output_size(job.size, session.canvas);
  if (!size) return size.error();
  session.size = *size;
  if (Result<void> chosen = choose_refinement(job, session, control); !chosen)
    return chosen.error();
  if (!session.start) {
    session.grid = session.refine == Refine::kDirect ? simulation_grid(*size, job, session.canvas)
                                                     : session.canvas;
  }
  choose_detail_start(job, session, control);
  session.steps = steps_to_simulate(session.plan, job, header.steps_per_second);
  tell_oddities(session, control);
  return session;
}

Result<std::unique_ptr<Simulation>> make_simulation(LogSession& session, const Threads& threads) {
  const log::Header& header = session.reader->header();
  SimulationSetup setup = simulation_setup(header, session.model);
  setup.geometry = session.grid;
  setup.basis = session.basis;
  setup.tips = session.tips;
  if (session.start) {
    setup.paper_m = paper_relief_of(session.start->state);
  } else {
    Result<Field<float>> relief = paper_relief(header.paper, session.grid, session.files);
    if (!relief) return relief.error();
    setup.paper_m = std::move(*relief);
  }
  auto simulation = std::make_unique<Simulation>(std::move(setup), threads);
  if (session.start) simulation->restore(std::move(session.start->state));
  return simulation;
}

std::uint32_t last_stroke_id(const CanvasState& state) {
  std::uint32_t last = 0;
  for (int y = 0; y < state.stroke.height(); ++y) {
    for (const std::uint32_t id : state.stroke.view().row_span(y)) last = std::max(last, id);
  }
  return last;
}

HandInput hand_input(LogSession& session, ReplaySubstrate* detail_substrate) {
  std::optional<Vec3f> gravity;
  if (session.gravity) gravity = core_gravity(*session.gravity);
  return {session.brushes, session.palette,  session.first_color, session.files,
          gravity,         detail_substrate, session.maker};
}

}  // namespace pentimento
