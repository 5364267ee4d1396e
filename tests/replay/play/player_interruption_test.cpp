#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "replay/play/player.h"
#include "replay/session/log_plan.h"
#include "tests/replay/list_reader.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

/// A wet stroke and a dry one, interrupted while event `at` is read.
class InterruptingReader final : public test::ListReader {
 public:
  InterruptingReader() {
    head.canvas_width_m = 0.4;
    head.canvas_height_m = 0.3;
    add(0, log::Color{{}, log::Rgb{0.02, 0.05, 0.4}, {}});
    stroke(0.1, 0.3, 0.05, 0.3, 0.1, 30);
    add(0.35, log::Dry{});
    stroke(0.4, 0.5, 0.3, 0.1, 0.12, 30);
    add(0.6, log::Mark{"end"});
  }
  Result<std::optional<log::Event>> next() override {
    if (next_++ == at) cancelled = true;
    return ListReader::next();
  }
  std::size_t at = std::numeric_limits<std::size_t>::max();
  std::atomic<bool> cancelled{false};

 private:
  std::size_t next_ = 0;
};

/// Ends the replay in the pause after the interruption; within a step after so many cues more.
struct EndingPause final : StepPause {
  explicit EndingPause(const Control& the_control, int cues) : control(the_control), left(cues) {}
  Result<void> between_steps() override { return control.go_on(); }
  Result<void> within_step() override {
    const Result<void> go = control.go_on();
    return go || left-- > 0 ? Result<void>() : go;
  }
  const Control& control;
  int left;
};

struct Ended {
  Result<void> played;
  bool between_steps;
};

enum class Pauses { kNone, kPatient, kHurried };

/// What does not depend on the interruption: mixing the paints takes longer than the replay.
struct Prepared {
  Prepared() : plan(plan_of_uninterrupted()), basis(palette_channels(plan.palette.pigments())) {}
  static LogPlan plan_of_uninterrupted() {
    InterruptingReader reader;
    LogFiles files("-", false);
    return plan_log(reader, files, {}).value();
  }
  LogPlan plan;
  ChannelBasis basis;
};

/// Plays the log, which is interrupted at event `at`.
Ended play_until(std::size_t at, Pauses pauses) {
  static const Prepared kPrepared;
  const LogPlan& plan = kPrepared.plan;
  InterruptingReader reader;
  reader.at = at;
  Control control;
  control.cancelled = &reader.cancelled;
  LogFiles files("-", false);
  const BrushTable brushes;
  SimulationSetup setup;
  setup.geometry = {32, 24, 0.4, 0.3};
  setup.basis = kPrepared.basis;
  setup.paper_m = Field<float>(32, 24);
  const Threads threads(1);
  Simulation simulation(std::move(setup), threads);
  Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
  Hand hand(simulation, {brushes, plan.palette, 0, files, std::nullopt});
  LightingTrack lighting(default_lighting(), 45);
  EndingPause pause(control, pauses == Pauses::kPatient ? std::numeric_limits<int>::max() : 0);
  PlayerInput input{timeline, simulation, hand, lighting, files, control, plan.steps};
  if (pauses != Pauses::kNone) input.pause = &pause;
  Player player(input);
  Result<void> played = player.play_all(plan.steps);
  return {played, player.is_between_steps()};
}

constexpr std::size_t kEvents = 1 + 31 + 1 + 31 + 1;

TEST(PlayerInterruption, EndsASavedReplayBetweenStepsWhereverItComes) {
  for (std::size_t at = 0; at < kEvents; at += test::kStride) {
    const Ended ended = play_until(at, Pauses::kPatient);
    ASSERT_FALSE(ended.played) << "event " << at;
    EXPECT_EQ(ended.played.error().code, ErrorCode::kInterrupted);
    EXPECT_TRUE(ended.between_steps) << "event " << at;
  }
  EXPECT_TRUE(play_until(kEvents + 1, Pauses::kPatient).played);
}

/// Of the events, how many interruptions ended the replay within a step.
int ends_within_steps(Pauses pauses) {
  int within = 0;
  for (std::size_t at = 0; at < kEvents; at += test::kStride) {
    const Ended ended = play_until(at, pauses);
    EXPECT_FALSE(ended.played) << "event " << at;
    if (!ended.between_steps) ++within;
  }
  return within;
}

TEST(PlayerInterruption, EndsAnyOtherAtOnceAlsoWithinAStep) {
  EXPECT_GT(ends_within_steps(Pauses::kNone),
            20 / test::kStride);  // most events are not the first of their step
}

TEST(PlayerInterruption, APauseCanEndTheReplayWithinAStep) {
  EXPECT_GT(ends_within_steps(Pauses::kHurried), 20 / test::kStride);
}

}  // namespace
}  // namespace pentimento
