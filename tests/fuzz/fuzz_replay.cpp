#include "tests/fuzz/fuzz_replay.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/fluid/conservative/tiles/quantum.h"
#include "formats/checkpoint/canvas_part.h"
#include "formats/checkpoint/memory_part.h"
#include "formats/hdf5/state_dump.h"
#include "replay/paper/paper_relief.h"
#include "replay/play/player.h"
#include "replay/session/log_plan.h"
#include "replay/session/simulation_setup.h"
#include "tests/fuzz/choices.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/grammar_log.h"

namespace pentimento::test {

namespace {

/// What a checkpoint holds of a replay on the log's grid.
struct Saved {
  std::string canvas, memory;
  PlayPosition position;
};

/// All that the replays of one log share.
struct Session {
  explicit Session(ListReader read)
      : log(std::move(read)), maker(log.head.model), plan(plan_log(log, files, {}, maker).value()) {
    basis = make_channels(plan.palette.pigments(), maker.wavelength_nm());
  }
  ListReader log;
  LogFiles files{"-", false};
  PaintMaker maker;
  LogPlan plan;
  ChannelBasis basis;
};

/// The relief of the paper, which every log of the grammar has.
const Field<float>& relief(const log::Header& head) {
  static LogFiles none("-", false);
  static const Result<Field<float>> made = paper_relief(
      head.paper, {head.grid_width, head.grid_height, head.canvas_width_m, head.canvas_height_m},
      none);
  return *made;
}

const BrushTable& brushes() {
  static const BrushTable table;
  return table;
}

/// A simulation before its first step. To draw the tip of a brush takes a hundred times as long as
/// a replay, so all share their tips.
std::unique_ptr<Simulation> fresh_simulation(const Session& session, const Threads& threads) {
  static const auto tips = std::make_shared<TipRack>();
  SimulationSetup setup = simulation_setup(session.log.head, session.log.head.model);
  setup.basis = session.basis;
  setup.paper_m = relief(session.log.head).clone();
  setup.tips = tips;
  return std::make_unique<Simulation>(std::move(setup), threads);
}

/// One replay of the session's log. Saves it once on the way if it is asked to.
class Replay final : public StepPause {
 public:
  Replay(Session& session, const Threads& threads)
      : session_(session),
        simulation_(fresh_simulation(session, threads)),
        timeline_((rewind(session.log), session.log),
                  {session.plan.undo, brushes(), session.plan.stepped, 1}),
        hand_(*simulation_, {brushes(), session.plan.palette, 0, session.files, std::nullopt,
                             nullptr, session.maker}),
        lighting_(default_lighting(), session.log.head.steps_per_second),
        player_({timeline_, *simulation_, hand_, lighting_, session.files, control_,
                 session.plan.steps, nullptr, this}) {}

  void save_at(std::int64_t step) { save_at_ = step; }
  const std::optional<Saved>& saved() const { return saved_; }

  void go_on_from(const Saved& saved) {
    PENTIMENTO_CHECK(player_.skip_to(saved.position).ok());
    const CanvasState& fresh = simulation_->state();
    checkpoint::ArchiveReader canvas(saved.canvas), memory(saved.memory);
    CanvasState state = checkpoint::take_canvas(
        {fresh.geometry, fresh.layers, fresh.channels, fresh.bands}, canvas);
    const SimulationMemory kept = checkpoint::take_memory(memory);
    PENTIMENTO_CHECK(canvas.complete() && memory.complete());
    PENTIMENTO_CHECK(simulation_->fits(kept));
    simulation_->recall(std::move(state), kept);
  }

  void play() {
    const Result<void> played = player_.play_all(session_.plan.steps);
    if (!played) std::fprintf(stderr, "%s\n", played.error().message.c_str());
    PENTIMENTO_CHECK(played.ok());
  }

  Result<void> between_steps() override {
    if (saved_ || save_at_ < 0 || player_.steps() < save_at_) return {};
    checkpoint::ArchiveWriter canvas, memory;
    checkpoint::put_canvas(simulation_->state(), canvas);
    checkpoint::put_memory(simulation_->memory(), memory);
    saved_ = Saved{canvas.take(), memory.take(), player_.position()};
    return {};
  }
  Result<void> within_step() override { return {}; }

  std::string hash() const { return state_sha256(simulation_->state()); }
  const Simulation& simulation() const { return *simulation_; }

 private:
  static void rewind(ListReader& log) { PENTIMENTO_CHECK(log.rewind().ok()); }

  Session& session_;
  const Control control_;
  std::unique_ptr<Simulation> simulation_;
  Timeline timeline_;
  Hand hand_;
  LightingTrack lighting_;
  Player player_;
  std::int64_t save_at_ = -1;
  std::optional<Saved> saved_;
};

void check_line(double deposited, double picked_up, double dried, double wet, double traces) {
  // The layers' exchanges round once per stamp and cell, at 6e-8.
  constexpr double kRounding = 1e-6;
  const double moved = std::max({deposited, picked_up, dried, wet});
  const double lost = std::abs(deposited - picked_up - dried - wet);
  if (lost > kRounding * moved + traces)
    std::fprintf(stderr, "deposited %g, picked up %g, dried %g, wet %g\n", deposited, picked_up,
                 dried, wet);
  PENTIMENTO_CHECK(lost <= kRounding * moved + traces);
}

/// The published fluid loses paint; the other must not, but for half a quantum per stamp, plane and
/// layer.
void check_account(const Simulation& simulation) {
  const Model& model = simulation.model();
  if (model.scheme == SchemeKind::kPaper) return;
  const PaintAccount& account = simulation.account();
  const PaintFlow wet = simulation.wet();
  const CanvasGeometry& grid = simulation.geometry();
  const double cell_m2 = grid.width_m * grid.height_m / (grid.width * grid.height);
  const double roundings =
      static_cast<double>(simulation.memory().stamps + 1) * model.layers * 0.5 * cell_m2;
  check_line(account.deposited.medium_m3, account.picked_up.medium_m3, account.dried.medium_m3,
             wet.medium_m3,
             roundings * static_cast<double>(conservative::quantum_for(model.max_medium_m)));
  for (std::size_t c = 0; c < wet.channel.size(); ++c)
    check_line(account.deposited.channel[c], account.picked_up.channel[c], account.dried.channel[c],
               wet.channel[c],
               roundings * static_cast<double>(conservative::quantum_for(model.max_pigment)));
}

}  // namespace

void fuzz_replay(std::string_view bytes) {
  static const Threads one(1), three(3), reversed = Threads::backwards();
  Choices choices(bytes);
  const std::uint8_t how = choices.byte();
  Session session(grammar_log(choices));
  Replay plain(session, one);
  plain.save_at(how % 32);
  plain.play();
  PENTIMENTO_CHECK(plain.simulation().first_non_finite().empty());
  check_account(plain.simulation());
  const std::string hash = plain.hash();
  // Real threads take turns on a loaded machine: most inputs see their other order without them.
  constexpr int kOneInAsManyByThreads = 8;
  Replay other(session, how / 32 % kOneInAsManyByThreads == 0 ? three : reversed);
  other.play();
  PENTIMENTO_CHECK(other.hash() == hash);
  if (!plain.saved()) return;
  Replay resumed(session, one);
  resumed.go_on_from(*plain.saved());
  resumed.play();
  PENTIMENTO_CHECK(resumed.hash() == hash);
}

}  // namespace pentimento::test
