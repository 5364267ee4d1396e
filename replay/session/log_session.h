#pragma once
// A session: a log that was opened and read once, and all that is known before the first step. A
// session serves for one replay.

#include <memory>

#include "core/base/result.h"
#include "core/simulation/simulation.h"
#include "formats/hdf5/state_dump.h"
#include "formats/log/reader.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/log/brushes.h"
#include "replay/log/log_files.h"
#include "replay/play/hand.h"
#include "replay/play/replay_detail.h"
#include "replay/session/log_plan.h"

namespace pentimento {

struct LogSession {
  std::unique_ptr<log::Reader> reader;  // stands before the first event
  LogFiles files{"", false};
  LogPlan plan;
  BrushTable brushes;
  Model model;          // the header's with the job's changes
  PaintMaker maker;     // of the model's optics
  Palette palette;      // of the dump, if any, and the log
  int first_color = 0;  // index of what the first brush is loaded with
  ChannelBasis basis;
  // Of the estimate and of the replay: each tip is drawn once.
  std::shared_ptr<TipRack> tips = std::make_shared<TipRack>();
  std::optional<StateDump> start;  // --from, its guide's channels in `basis`; without its `fine`
  std::optional<DetailStart> detail_start;  // the detail canvas that goes on
  CanvasGeometry canvas;                    // the log's grid
  std::optional<log::Gravity> gravity;      // --gravity, in place of the log's
  OutputSize size;
  CanvasGeometry grid;  // of the simulation
  Refine refine = Refine::kGuided;
  int detail = 1;          // fine cells per cell of `grid`
  std::int64_t steps = 0;  // to be simulated
};

/// Opens a session. Errors: those of the log, its files and the dump; kUsage for options that do
/// not fit these.
Result<LogSession> open_session(const RenderJob& job, const Control& control);

/// The simulation for the session's replay. Moves the state out of `session.start`. Errors: those
/// of the paper's texture.
Result<std::unique_ptr<Simulation>> make_simulation(LogSession& session, const Threads& threads);

/// The largest id of a stroke on the canvas, 0 if there is none.
std::uint32_t last_stroke_id(const CanvasState& state);

/// For the hand that plays the session's log. `detail_substrate`: of the detail canvas, if there is
/// one.
HandInput hand_input(LogSession& session, ReplaySubstrate* detail_substrate = nullptr);

}  // namespace pentimento
