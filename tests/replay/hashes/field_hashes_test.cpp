#include "replay/hashes/field_hashes.h"

#include <gtest/gtest.h>

#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "replay/play/player.h"
#include "replay/session/log_session.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

/// kSmallLog, and later, when its paint sleeps, a drying and a stroke in another place.
const std::string kLongLog = test::kSmallLog +
                             R"({"t":4,"type":"dry"})"
                             "\n"
                             R"({"t":5,"type":"touch","phase":"down","x":0.05,"y":0.25})"
                             "\n"
                             R"({"t":5.2,"type":"touch","phase":"up","x":0.1,"y":0.2})"
                             "\n"
                             R"({"t":8,"type":"mark","name":"rest"})"
                             "\n";

Result<void> replay(const RenderJob& job, StepObserver& observer) {
  Result<LogSession> session = open_session(job, {});
  if (!session) return session.error();
  const Threads threads(job.threads);
  Result<std::unique_ptr<Simulation>> simulation = make_simulation(*session, threads);
  if (!simulation) return simulation.error();
  Timeline timeline(*session->reader, {session->plan.undo, session->brushes, false, 1});
  Hand hand(**simulation, hand_input(*session));
  LightingTrack lighting(default_lighting(), 45);
  const Control control;
  Player player(
      {timeline, **simulation, hand, lighting, session->files, control, session->steps, &observer});
  return player.play_all(session->plan.steps);
}

/// Compares hashes that are kept up to date with those of the whole canvas, after every step.
class AgainstTheWhole final : public StepObserver {
 public:
  Result<void> stepped(const CanvasState& state, std::int64_t, bool whole_canvas) override {
    const Threads threads(1);
    if (!kept_) kept_.emplace(state.geometry, kTile_m);
    kept_->update(state, threads, whole_canvas);
    FieldHashes whole(state.geometry, kTile_m);
    whole.update(state, threads);
    EXPECT_EQ(kept_->fields(), whole.fields()) << "after step " << state.step;
    const std::size_t all = whole.changed().size();
    fewest_ = std::min(fewest_, kept_->changed().size());
    EXPECT_LE(kept_->changed().size(), all);
    ++steps_;
    return {};
  }
  std::size_t fewest() const { return fewest_; }
  int steps() const { return steps_; }

 private:
  static constexpr float kTile_m = Model().sleep_tile_m;
  std::optional<FieldHashes> kept_;
  std::size_t fewest_ = 1000;
  int steps_ = 0;
};

TEST(FieldHashes, KeptUpToDateTheyAreThoseOfTheWholeCanvas) {
  const JobFolder folder(kLongLog);
  AgainstTheWhole observer;
  ASSERT_TRUE(replay(folder.job({}), observer));
  EXPECT_GT(observer.steps(), 40);
  EXPECT_LT(observer.fewest(), 4U) << "paint comes to rest";
}

TEST(FieldHashes, EachFieldHasItsOwnAndNamesItsTile) {
  const Threads threads(1);
  // 8 x 6 tiles of 8 x 8 cells.
  CanvasState state = make_canvas_state({64, 48, 0.4, 0.3}, 2, 3, 3, 0.9f);
  state.sleep.assign(48 * conservative::kSleepValues, 0.0f);
  FieldHashes hashes(state.geometry, 0.05f);
  ASSERT_EQ(hashes.tile_width(), 8);
  hashes.update(state, threads);
  EXPECT_EQ(hashes.changed().size(), 48U);
  const std::vector<std::function<void()>> changes = {
      [&] { state.depth_m(9, 17) = 1e-30f; },
      [&] { state.velocity_x_m_s(9, 17) = -0.0f; },  // other bits
      [&] { state.velocity_y_m_s(9, 17) = 1; }, [&] { state.base_m(9, 17) = 1; },
      [&] { state.reflectance[2].set(9, 17, 1); }, [&] { state.channel(1, 2)(9, 17) = 1; },
      [&] { state.stroke(9, 17) = 1; },
      // The third row's second tile falls asleep, all others are awake.
      [&] { state.sleep[(2 * 8 + 1) * conservative::kSleepValues] = 1; }};
  ASSERT_EQ(changes.size(), kHashedFields.size());
  for (std::size_t f = 0; f < changes.size(); ++f) {
    const FieldHashArray before = hashes.fields();
    changes[f]();
    hashes.update(state, threads, true);
    for (std::size_t other = 0; other < before.size(); ++other)
      EXPECT_EQ(hashes.fields()[other] != before[other], other == f) << kHashedFields[other];
    ASSERT_EQ(hashes.changed().size(), 1U);
    const CellBox box = hashes.box(hashes.changed()[0].tile);
    EXPECT_EQ(box.x0, 8);
    EXPECT_EQ(box.y0, 16);
  }
}

TEST(FieldHashes, ATileMovedIsAnotherCanvas) {
  const Threads threads(1);
  CanvasState a = make_canvas_state({64, 48, 0.4, 0.3}, 2, 3, 3, 0.9f);
  a.depth_m(3, 3) = 1;
  CanvasState b = make_canvas_state({64, 48, 0.4, 0.3}, 2, 3, 3, 0.9f);
  b.depth_m(11, 3) = 1;
  FieldHashes of_a(a.geometry, 0.05f), of_b(b.geometry, 0.05f);
  of_a.update(a, threads);
  of_b.update(b, threads);
  EXPECT_NE(of_a.fields()[0], of_b.fields()[0]);
  EXPECT_EQ(of_a.fields()[1], of_b.fields()[1]);
}

}  // namespace
}  // namespace pentimento
