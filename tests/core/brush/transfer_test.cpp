#include "core/brush/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "core/brush/builtin_brushes.h"
#include "core/brush/held_brush.h"
#include "tests/core/three_pigments.h"

namespace pentimento {
namespace {

// What stamps do is tested in tests/core/simulation/simulation_test.cpp and
// tests/core/brush/stamp_plan_test.cpp.

constexpr CanvasGeometry kTransferGrid = {120, 90, 0.12, 0.09};

/// Stamps of a drying brush, each told of the next, on a canvas of its own.
class AheadTest : public ::testing::Test {
 protected:
  /// How many of ten stamps of `diameter_m` had their tip drawn beside the one before.
  std::int64_t drawn_ahead(int threads_wanted, float diameter_m,
                           StampListener* listener = nullptr) {
    const Threads threads(threads_wanted);
    CanvasState state = make_canvas_state(kTransferGrid, 2, basis_.channels(), 1, 1);
    BrushContact contact = make_brush_contact(kTransferGrid.width, kTransferGrid.height);
    PaintAccount account;
    for (PaintFlow* flow : {&account.deposited, &account.picked_up, &account.dried})
      flow->channel.assign(static_cast<std::size_t>(basis_.channels()), 0.0);
    HeldBrush held(basis_, model_);
    EXPECT_TRUE(held.take(*builtin_brush("bristle")));
    Reservoir reservoir(basis_.channels());
    reservoir.fill(held.load());
    const std::vector<float> amount(basis_.amount.begin(), basis_.amount.end());
    Transfer transfer(state, contact, account, amount, threads);
    transfer.set_listener(listener);
    const BrushInHand hand{held.brush(), held.tip(), held.settings(), held.load(), 1};
    for (int i = 0; i < 10; ++i) {
      const Stamp now = stamp(i, diameter_m), next = stamp(i + 1, diameter_m);
      transfer.apply(now, &next, hand, model_, reservoir);
    }
    EXPECT_GT(account.deposited.medium_m3, 0);
    EXPECT_LT(reservoir.density_frac, 1);
    return transfer.drawn_ahead();
  }

 private:
  static Stamp stamp(int i, float diameter_m) {
    Stamp stamp;
    stamp.x_m = 0.04 + 0.002 * i;
    stamp.y_m = 0.045;
    stamp.diameter_m = diameter_m;
    stamp.direction = stamp.heading = {1, 0};
    stamp.travel_m = 0.002f;
    return stamp;
  }
  const ChannelBasis basis_ = palette_channels(test::three_pigments());
  const Model model_ = {};
};

/// Notes in which order it is told of a stamp; of the tip it is told on any thread.
class NotingListener : public StampListener {
 public:
  void begin_stamp() override { told_ += '('; }
  void draw_tip(const StampPlan& plan) override {
    EXPECT_GT(plan.stamp.diameter_m, 0);
    ++tips_;
  }
  void before_deposit(const StampPlan&, const CanvasState&) override { told_ += '-'; }
  void after_deposit(const StampPlan&, const CanvasState&) override { told_ += '+'; }
  void end_stamp() override {
    EXPECT_EQ(tips_.exchange(0), 1) << "one tip to each stamp, and it is drawn";
    told_ += ')';
  }
  const std::string& told() const { return told_; }

 private:
  std::string told_;
  std::atomic<int> tips_ = 0;
};

TEST_F(AheadTest, TheNextTipIsDrawnBesideASmallStamp) {
  EXPECT_EQ(drawn_ahead(2, 0.02f), 9);  // all but the first, though the brush dries
}

TEST_F(AheadTest, NotWhereAStampHasWorkForAllThreads) {
  EXPECT_EQ(drawn_ahead(2, 0.07f), 0);
}

TEST_F(AheadTest, NotByOneThread) {
  EXPECT_EQ(drawn_ahead(1, 0.02f), 0);
}

TEST_F(AheadTest, AListenersTipIsDrawnBesideTheStampToo) {
  std::string ten;
  for (int i = 0; i < 10; ++i) ten += "(-+)";
  for (const float diameter_m : {0.02f, 0.07f}) {
    for (const int threads : {1, 2, 3}) {
      NotingListener listener;
      EXPECT_EQ(drawn_ahead(threads, diameter_m, &listener),
                threads > 1 && diameter_m < 0.05f ? 9 : 0);
      EXPECT_EQ(listener.told(), ten);
    }
  }
}

}  // namespace
}  // namespace pentimento
