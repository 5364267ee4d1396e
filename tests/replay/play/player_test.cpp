#include "replay/play/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "formats/hdf5/state_dump.h"
#include "replay/session/log_plan.h"
#include "tests/replay/list_reader.h"

namespace pentimento {
namespace {

using test::ListReader;

/// A replay on 64 x 48 cells of 0.4 x 0.3 m.
struct Replayed {
  std::unique_ptr<Simulation> simulation;
  std::int64_t computed = 0;
};

Replayed replay(ListReader& reader, bool optical = false) {
  static const Threads kThreads(1);  // the simulation outlives this call
  LogFiles files("-", false);
  const Control control;
  LogPlan plan = plan_log(reader, files, {}).value();
  const BrushTable brushes;
  SimulationSetup setup;
  setup.geometry = {64, 48, 0.4, 0.3};
  setup.basis = optical ? optical_channels(plan.palette.pigments())
                        : palette_channels(plan.palette.pigments());
  setup.paper_m = Field<float>(64, 48);
  Replayed result;
  result.simulation = std::make_unique<Simulation>(std::move(setup), kThreads);
  Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
  Hand hand(*result.simulation, {brushes, plan.palette, 0, files, std::nullopt});
  LightingTrack lighting(default_lighting(), 45);
  Player player({timeline, *result.simulation, hand, lighting, files, control, plan.steps});
  EXPECT_TRUE(player.play_all(plan.steps).ok());
  result.computed = player.steps_computed();
  return result;
}

ListReader header() {
  ListReader reader;
  reader.head.canvas_width_m = 0.4;
  reader.head.canvas_height_m = 0.3;
  return reader;
}

log::Color picked(double r, double g, double b) {
  return {{}, log::Rgb{r, g, b}, {}};
}

ListReader two_colours() {
  ListReader reader = header();
  reader.add(0, picked(0.02, 0.05, 0.4));
  reader.stroke(0.1, 0.5, 0.05, 0.3, 0.1);
  reader.add(0.6, picked(0.6, 0.5, 0.02));
  reader.stroke(0.7, 1.1, 0.3, 0.1, 0.12);
  return reader;
}

TEST(Player, SkippingIdleStepsIsExact) {
  ListReader skipping = two_colours();
  skipping.add(1.2, log::Dry{});
  skipping.add(60.0, log::Mark{"late"});
  // The same with something happening at every step, which changes nothing.
  ListReader stepping = two_colours();
  stepping.add(1.2, log::Dry{});
  for (int i = 55; i < 45 * 60; ++i) stepping.add((i + 0.5) / 45, log::Mark{"tick"});
  stepping.add(60.0, log::Mark{"late"});
  const Replayed a = replay(skipping);
  const Replayed b = replay(stepping);
  EXPECT_EQ(a.simulation->state().step, b.simulation->state().step);
  EXPECT_EQ(state_sha256(a.simulation->state()), state_sha256(b.simulation->state()));
  EXPECT_LT(a.computed, 100);
  EXPECT_GT(b.computed, 2000);
}

TEST(Player, CuesOfTheStepAtWhichItStopsAreLeftForLater) {
  // Mark and stop in one step: what is said at 0.5 s acts in step 22, so that step 22 is not yet
  // tilted when 22 steps are done, and is when 23 are.
  const auto tilted_after = [](std::int64_t steps) {
    ListReader reader = header();
    reader.add(0.5, log::Gravity{9, 0, 1});
    reader.add(1.0, log::Mark{"end"});
    LogFiles files("-", false);
    const Control control;
    const Threads threads(1);
    LogPlan plan = plan_log(reader, files, {}).value();
    const BrushTable brushes;
    SimulationSetup setup;
    setup.geometry = {64, 48, 0.4, 0.3};
    setup.basis = palette_channels(plan.palette.pigments());
    setup.paper_m = Field<float>(64, 48);
    Simulation simulation(std::move(setup), threads);
    Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
    Hand hand(simulation, {brushes, plan.palette, 0, files, std::nullopt});
    LightingTrack lighting(default_lighting(), 45);
    Player player({timeline, simulation, hand, lighting, files, control, plan.steps});
    EXPECT_TRUE(player.play_to(steps).ok());
    EXPECT_EQ(player.steps(), steps);
    return lighting.gravity().x_m_s2 == 9;
  };
  EXPECT_FALSE(tilted_after(22));
  EXPECT_TRUE(tilted_after(23));
}

TEST(Player, UndoneStrokesLeaveNoTrace) {
  ListReader plain = two_colours();
  plain.add(3.0, log::Mark{"end"});
  ListReader undone = two_colours();
  undone.stroke(1.2, 1.6, 0.1, 0.3, 0.2);
  undone.add(1.7, log::Undo{});
  undone.add(3.0, log::Mark{"end"});
  EXPECT_EQ(state_sha256(replay(plain).simulation->state()),
            state_sha256(replay(undone).simulation->state()));
}

TEST(Player, ARedoneStrokeIsAsIfItWasNeverUndone) {
  ListReader plain = two_colours();
  plain.add(3.0, log::Mark{"end"});
  ListReader redone = two_colours();
  redone.add(1.2, log::Undo{});
  redone.add(1.3, log::Redo{});
  redone.add(3.0, log::Mark{"end"});
  EXPECT_EQ(state_sha256(replay(plain).simulation->state()),
            state_sha256(replay(redone).simulation->state()));
}

TEST(Player, OpticalChannelsMixAsThePaletteDoes) {
  // Stiff paint: a thin film runs, and running amplifies the last bit of a rounding.
  const auto stiff = [] {
    ListReader reader = header();
    reader.add(0, log::Slider{"medium", 0.1});
    reader.add(0, log::Slider{"pigment", 1.0});
    reader.add(0, picked(0.02, 0.05, 0.4));
    reader.stroke(0.1, 0.5, 0.05, 0.3, 0.1);
    reader.add(0.6, picked(0.6, 0.5, 0.02));
    reader.stroke(0.7, 1.1, 0.3, 0.1, 0.12);
    return reader;
  };
  ListReader one = stiff();
  ListReader two = stiff();
  const Replayed palette = replay(one);
  const Replayed optical = replay(two, true);
  const CanvasState& p = palette.simulation->state();
  const CanvasState& o = optical.simulation->state();
  const ChannelBasis& basis = optical.simulation->basis();
  double largest = 0, error = 0;
  for (int layer = 0; layer < p.layers; ++layer) {
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        for (int c = 0; c < o.channels; ++c) {
          double sum = 0;
          for (int i = 0; i < p.channels; ++i) {
            sum += static_cast<double>(basis.load(c, i)) * p.channel(layer, i)(x, y);
          }
          largest = std::max(largest, sum);
          if (std::abs(sum - o.channel(layer, c)(x, y)) > 1e-3)
            std::printf("%d %d,%d c%d %g %g\n", layer, x, y, c, sum,
                        (double)o.channel(layer, c)(x, y));
          error = std::max(error, std::abs(sum - o.channel(layer, c)(x, y)));
        }
      }
    }
  }
  EXPECT_GT(largest, 0.01);  // there is paint
  // The same linear operations on other numbers: only the rounding differs, and a hundred steps and
  // some thousand stamps add it up.
  EXPECT_LT(error, 1e-3 * largest);
}

TEST(Player, ANumberThatIsNotFiniteIsFoundWithStepAndCell) {
  ListReader reader = header();
  reader.add(1.0, log::Mark{"end"});
  LogFiles files("-", false);
  const Control control;
  const Threads threads(1);
  LogPlan plan = plan_log(reader, files, {}).value();
  const BrushTable brushes;
  SimulationSetup setup;
  setup.geometry = {64, 48, 0.4, 0.3};
  setup.basis = palette_channels(plan.palette.pigments());
  setup.paper_m = Field<float>(64, 48);
  Simulation simulation(std::move(setup), threads);
  CanvasState broken = make_canvas_state({64, 48, 0.4, 0.3}, 2, 1, 3, 0.9f);
  broken.depth_m(3, 4) = std::numeric_limits<float>::quiet_NaN();
  simulation.restore(std::move(broken));
  Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
  Hand hand(simulation, {brushes, plan.palette, 0, files, std::nullopt});
  LightingTrack lighting(default_lighting(), 45);
  Player player({timeline, simulation, hand, lighting, files, control, plan.steps});
  const Result<void> played = player.play_all(plan.steps);
  ASSERT_FALSE(played.ok());
  EXPECT_EQ(played.error().code, ErrorCode::kNonFinite);
  EXPECT_EQ(played.error().message.substr(0, 5), "step ");
  EXPECT_NE(played.error().message.find("cell ("), std::string::npos) << played.error().message;
}

TEST(Player, UprightPaintRunsDown) {
  ListReader reader = header();
  reader.add(0, log::Slider{"medium", 1.0});
  reader.add(0, log::Slider{"pigment", 0.05});
  reader.add(0, log::Gravity{0, 9.81, 0});
  reader.stroke(0.0, 0.3, 0.15, 0.25, 0.08);
  reader.add(2.0, log::Mark{"end"});
  const Replayed end = replay(reader);
  const CanvasState& state = end.simulation->state();
  double mass = 0, moment = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      mass += static_cast<double>(state.depth_m(x, y));
      moment += static_cast<double>(state.depth_m(x, y)) * (y + 0.5) * 0.3 / 48;
    }
  }
  ASSERT_GT(mass, 0);
  EXPECT_GT(moment / mass, 0.085);  // painted at y = 0.08 m, y down
}

}  // namespace
}  // namespace pentimento
