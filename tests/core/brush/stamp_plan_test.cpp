#include "core/brush/stamp_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "core/brush/tip_footprint.h"
#include "core/optics/paints/pigment_library.h"
#include "core/simulation/simulation.h"
#include "tests/core/idle_listener.h"

namespace pentimento {
namespace {

/// `deviation_m`: of the paper's heights, which are two, from cell to cell.
SimulationSetup setup_of_one_pigment(float deviation_m = 0) {
  SimulationSetup setup;
  setup.geometry = {96, 72, 0.2, 0.15};
  setup.paper_m = Field<float>(96, 72);
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 96; ++x) setup.paper_m(x, y) = (x + y) % 2 == 0 ? 2 * deviation_m : 0;
  setup.basis = palette_channels({*find_library_pigment("Vermilion")});
  return setup;
}

Stamp stamp_at(double x_m, double y_m) {
  Stamp stamp;
  stamp.x_m = x_m;
  stamp.y_m = y_m;
  stamp.diameter_m = 0.04f;
  stamp.pressure = 0.8f;
  stamp.direction = stamp.heading = {0.6f, 0.8f};
  stamp.travel_m = 0.002f;
  return stamp;
}

/// Lays each stamp's height on a canvas of its own, `finer` times finer, with nothing but the plan.
/// For stamps on a dry canvas, where what was lifted does not change the heights levelled to.
class SecondCanvas : public test::IdleListener {
 public:
  explicit SecondCanvas(int finer) : finer_(finer) {}

  void before_deposit(const StampPlan& plan, const CanvasState& canvas) override {
    ++stamps;
    geometry_ = canvas.geometry;
    geometry_.width *= finer_;
    geometry_.height *= finer_;
    after = Field<float>(geometry_.width, geometry_.height);
    for (int y = 0; y < geometry_.height; ++y)
      for (int x = 0; x < geometry_.width; ++x)
        after(x, y) = canvas.depth_m(x / finer_, y / finer_);
    const FootprintBox box = box_of(plan.pose, plan.extent, geometry_);
    std::vector<float> paint(static_cast<std::size_t>(plan.stride));
    TipFootprint print;
    print.draw_cells(plan, std::sqrt(geometry_.dx_m() * geometry_.dy_m()));
    std::vector<float> values(static_cast<std::size_t>(box.width));
    for (int j = 0; j < box.height; ++j) {
      const int y = box.y + j;
      const TipRow tip = tip_row(plan.pose, box, geometry_, y);
      print.row(tip, 0, values);
      for (int i = 0; i < box.width; ++i) {
        const int x = box.x + i;
        const float value = values[static_cast<std::size_t>(i)];
        const float base_m = canvas.base_m(x / finer_, y / finer_);
        const float depth_m = canvas.depth_m(x / finer_, y / finer_);
        const float share = stamp_levelled(plan, value, 0, base_m, depth_m) * plan.share_scale;
        if (!(share > 0)) continue;
        plan.reservoir->sample(tip.u(i), tip.v(i), paint.data());
        const float volume = plan.load->volume_of(paint.data());
        after(x, y) += stamp_deposited(plan, volume, value, share).part * paint[0];
      }
    }
  }

  double volume_m3() const {
    double sum = 0;
    for (int y = 0; y < after.height(); ++y)
      for (int x = 0; x < after.width(); ++x) sum += static_cast<double>(after(x, y));
    return sum * geometry_.cell_area_m2();
  }

  int stamps = 0;
  Field<float> after;  // depth once the stamp is laid

 private:
  int finer_;
  CanvasGeometry geometry_;
};

struct Hand {
  Threads threads{1};
  Simulation sim;
  explicit Hand(CanvasListener& listener, float deviation_m = 0)
      : sim(setup_of_one_pigment(deviation_m), threads) {
    sim.set_color(0);
    sim.set_listener(&listener);
    sim.begin_stroke(0, 1);
  }
};

TEST(StampPlan, LaysTheSameBitsOnASecondCanvas) {
  SecondCanvas second(1);
  Hand hand(second);
  hand.sim.stamp(0, stamp_at(0.1, 0.07));
  ASSERT_EQ(second.stamps, 1);
  for (int y = 0; y < second.after.height(); ++y)
    ASSERT_EQ(std::memcmp(second.after.row(y), hand.sim.state().depth_m.row(y),
                          static_cast<std::size_t>(second.after.width()) * sizeof(float)),
              0)
        << "row " << y;
}

TEST(StampPlan, LaysAsMuchOnAFinerCanvas) {
  SecondCanvas second(4);
  Hand hand(second);
  hand.sim.stamp(0, stamp_at(0.1, 0.07));
  // Each grid samples the tip at its cells' centres. 19 of the coarse ones to a diameter are wider
  // than bristles: half of the 1 % within which Tip.LaysTheSameMassOnEveryGrid holds the grids.
  EXPECT_NEAR(second.volume_m3() / hand.sim.wet().medium_m3, 1, 5e-3);
}

/// Notes how far down each stamp reaches.
class Reach : public test::IdleListener {
 public:
  void before_deposit(const StampPlan& plan, const CanvasState&) override { plans.push_back(plan); }
  std::vector<StampPlan> plans;
};

TEST(StampPlan, HairsSinkIntoThickWetPaint) {
  // Ground of two heights, 0.1 mm above and below their mean: that is its deviation.
  constexpr float kDeviation_m = 1e-4f;
  Reach reach;
  Hand hand(reach, kDeviation_m);
  Stamp light = stamp_at(0.1, 0.07), full = light;
  light.pressure = 0.1f;
  full.pressure = 1;
  hand.sim.stamp(0, light);
  while (hand.sim.state().depth_m(48, 34) < 0.003f && reach.plans.size() < 500)
    for (const Stamp& stamp : {full, light}) hand.sim.stamp(0, stamp);
  const float dry = reach.plans.front().catch_offset;
  ASSERT_LT(dry, 2);
  bool thin = false, thick = false;
  for (const StampPlan& plan : reach.plans) {
    if (plan.catch_per_m == 0) continue;  // pressed, the brush reaches all
    const float film = (static_cast<float>(plan.mean_height_m) - plan.mean_base_m) / kDeviation_m;
    thin |= film > 1 && film < 2;
    thick |= film > 3;
    // Over a film of three deviations it reaches 2.8 of them: all. The brush empties by 5 %
    // meanwhile.
    EXPECT_NEAR(plan.catch_offset, dry + (2.8f - dry) * std::min(1.0f, film * film / 9), 0.3f)
        << film;
  }
  EXPECT_TRUE(thin && thick);
}

TEST(StampPlan, PaintThatLiesThereCatchesNoMore) {
  StampPlan plan;
  plan.catch_per_m = 1e4f;
  plan.catch_offset = 0.5f;
  plan.mean_base_m = 1e-4f;
  plan.mean_height_m = 3e-4;
  EXPECT_FLOAT_EQ(stamp_caught(plan, 1e-4f), 0.5f);  // on ground of mean height
  EXPECT_EQ(stamp_caught(plan, 1.6e-4f), 1);
  EXPECT_EQ(stamp_caught(plan, 0.4e-4f), 0);
  // A hollow that is filled to above the peaks around is still a hollow.
  EXPECT_EQ(stamp_levelled(plan, 1, 0, 0.4e-4f, 5e-4f), 0);
}

TEST(StampPlan, ABladeSmearsAVeilOverWhatStandsHigher) {
  StampPlan plan;
  plan.scrape_frac = 0.5f;
  plan.scrape_height_m = 1e-3f;
  plan.mean_height_m = 1e-3;
  EXPECT_EQ(stamp_level_factor(plan, 0, 5e-3f), 0.04f);
  EXPECT_NEAR(stamp_level_factor(plan, 0, 1e-3f - 0.75e-4f), 0.5f, 1e-4f);
  EXPECT_EQ(stamp_level_factor(plan, 0, 0.8e-3f), 1);  // room to the edge and more
  EXPECT_EQ(stamp_level_factor(plan, 1, 5e-3f), 1);    // its ends are open
}

TEST(StampListener, IsToldOfEachStampAlsoAfterClearing) {
  SecondCanvas second(1);
  Hand hand(second);
  hand.sim.stamp(0, stamp_at(0.1, 0.07));
  hand.sim.clear();
  hand.sim.stamp(0, stamp_at(0.1, 0.07));
  EXPECT_EQ(second.stamps, 2);
  hand.sim.stamp(0, stamp_at(-1, 0.07));  // off the canvas: nothing is laid
  EXPECT_EQ(second.stamps, 2);
  hand.sim.set_listener(nullptr);
  hand.sim.stamp(0, stamp_at(0.1, 0.07));
  EXPECT_EQ(second.stamps, 2);
}

}  // namespace
}  // namespace pentimento
