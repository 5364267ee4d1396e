#include "core/simulation/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/base/give_back.h"
#include "core/brush/builtin_brushes.h"
#include "tests/core/base/resident_memory.h"
#include "tests/core/simulation/strokes.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

using namespace test;

void paint(Simulation& sim, const StrokePlan& plan, double spacing = kSpacing) {
  sim.set_color(plan.pigment);
  sim.begin_stroke(plan.touch, plan.id);
  for (const Stamp& stamp : stamps_of(plan.samples, spacing)) sim.stamp(plan.touch, stamp);
  sim.end_stroke(plan.touch);
}

/// Two crossing strokes and a third through both.
void paint_crossing(Simulation& sim) {
  paint(sim, {{at(0.03, 0.03, 0), at(0.1, 0.08, 0.3), at(0.17, 0.1, 0.6)}, 0, 1, 0});
  paint(sim, {{at(0.03, 0.1, 1), at(0.1, 0.07, 1.3), at(0.17, 0.03, 1.6)}, 1, 2, 0});
  paint(sim, {{at(0.1, 0.02, 2, 0.5f), at(0.1, 0.13, 2.5, 1)}, 2, 3, 0});
}

double relative_l2(const Field<float>& a, const Field<float>& b) {
  double difference = 0, size = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const double p = static_cast<double>(a(x, y)), q = static_cast<double>(b(x, y));
      difference += (p - q) * (p - q);
      size += q * q;
    }
  }
  return std::sqrt(difference / size);
}

double plane_sum(const Field<float>& plane) {
  double sum = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) sum += static_cast<double>(plane(x, y));
  return sum;
}

/// Balance of one flow, relative to what was deposited.
double imbalance(double deposited, double picked_up, double dried, double wet) {
  return std::abs(deposited - picked_up - dried - wet) / deposited;
}

TEST(Simulation, BrushAndCanvasKeepThePaintBetweenThem) {
  const Threads threads(1);
  for (const char* brush : {"round", "bristle", "knife"}) {
    Simulation sim(setup_of(128, 2), threads);
    sim.set_brush(*builtin_brush(brush));
    paint_crossing(sim);
    const PaintAccount& account = sim.account();
    const PaintFlow wet = sim.wet();
    // The books add up the differences of the stored floats in double: only the layers' own
    // exchanges (mixing, merging) round, once per stamp and cell at 6e-8.
    EXPECT_LT(imbalance(account.deposited.medium_m3, account.picked_up.medium_m3, 0, wet.medium_m3),
              1e-13);
    EXPECT_GT(account.picked_up.medium_m3, 0);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LT(
          imbalance(account.deposited.channel[c], account.picked_up.channel[c], 0, wet.channel[c]),
          1e-6)
          << brush << " channel " << c;
  }
}

TEST(Simulation, OnePassLaysTheSameFilmAtAnySpacing) {
  const Threads threads(1);
  double reference_m3 = 0;
  for (const double spacing : {0.01, 0.02, 0.03, 0.05}) {
    Simulation sim(setup_of(160, 2), threads);
    BrushSettings settings;
    settings.pickup = 0;  // what is lifted comes back, but later
    sim.set_settings(settings);
    paint(sim, {{at(0.03, 0.07, 0), at(0.17, 0.07, 1)}, 0, 1, 0}, spacing);
    const double volume = sim.account().deposited.medium_m3;
    if (reference_m3 == 0) {
      reference_m3 = volume;
      // 0.14 m of a film 1 mm high (half of 2 mm) and 20 mm wide; the brush dries by 1/400 per
      // diameter on the way, 0.875 % of the mean.
      EXPECT_NEAR(volume, 0.14 * 1e-3 * 0.02 * (1 - 0.00875), 0.14 * 1e-3 * 0.02 * 0.002);
    }
    // The drying of the brush is counted per stamp: half a stamp more or less of 140.
    EXPECT_NEAR(volume / reference_m3, 1, 1e-3) << "spacing " << spacing;
  }
}

TEST(Simulation, TheDevicesRateDoesNotChangeThePicture) {
  const Threads threads(1);
  const auto painted = [&](int rate_Hz) {
    Simulation sim(setup_of(160, 2), threads);
    sim.set_brush(*builtin_brush("bristle"));
    for (int k = 0; k < 2; ++k) {
      StrokePlan plan;
      plan.pigment = k;
      plan.id = static_cast<std::uint32_t>(k + 1);
      for (int i = 0; i <= rate_Hz; ++i) {
        const double t = static_cast<double>(i) / rate_Hz;
        plan.samples.push_back(at(0.1 + 0.06 * std::cos(4 * t + k), 0.07 + 0.045 * std::sin(5 * t),
                                  t, static_cast<float>(0.6 + 0.3 * std::sin(6 * t))));
      }
      paint(sim, plan);
    }
    CanvasState state = make_canvas_state(sim.state().geometry, 2, 3, 3, 1);
    state.depth_m = sim.state().depth_m.clone();
    for (std::size_t i = 0; i < state.pigment.size(); ++i)
      state.pigment[i] = sim.state().pigment[i].clone();
    return state;
  };
  const CanvasState slow = painted(30), fast = painted(240);
  // At 30 Hz the spline cuts the curve by up to 1 % of the diameter, 0.2 mm, an eighth of a cell:
  // bristle marks 2 cells wide then differ by a few percent of their height.
  EXPECT_LT(relative_l2(slow.depth_m, fast.depth_m), 0.03);
  for (int c = 0; c < 2; ++c)
    EXPECT_LT(relative_l2(slow.channel(1, c), fast.channel(1, c)), 0.06) << "channel " << c;
}

TEST(Simulation, ThreadsDoNotChangeABit) {
  const auto painted = [&](int count, Simulation& sim) {
    (void)count;
    sim.set_brush(*builtin_brush("bristle"));
    BrushSettings settings;
    settings.size_m = 0.06f;
    sim.set_settings(settings);
    StrokePlan plan{{at(0.05, 0.05, 0), at(0.12, 0.08, 0.5), at(0.15, 0.12, 1)}, 0, 1, 0};
    for (TouchSample& s : plan.samples) s.diameter_m = 0.08f;  // 96 cells: worth threads
    paint(sim, plan);
    plan.pigment = 1;
    plan.id = 2;
    paint(sim, plan);
    sim.step();
  };
  const Threads one(1), two(2), seven(7);
  Simulation a(setup_of(240, 2), one), b(setup_of(240, 2), two), c(setup_of(240, 2), seven);
  painted(1, a);
  painted(2, b);
  painted(7, c);
  expect_same_bits(a.state(), b.state());
  expect_same_bits(a.state(), c.state());
  EXPECT_EQ(a.account().deposited.medium_m3, c.account().deposited.medium_m3);
  EXPECT_EQ(a.account().picked_up.channel, c.account().picked_up.channel);
}

TEST(Simulation, TouchesThatDoNotMeetDoNotMind) {
  const Threads threads(1);
  const StrokePlan left{{at(0.03, 0.03, 0), at(0.06, 0.12, 1)}, 0, 1, 0};
  const StrokePlan right{{at(0.15, 0.03, 0), at(0.17, 0.12, 1)}, 0, 2, 1};
  Simulation ordered(setup_of(128, 2), threads);
  paint(ordered, left);
  paint(ordered, right);

  Simulation woven(setup_of(128, 2), threads);
  const auto a = stamps_of(left.samples), b = stamps_of(right.samples);
  woven.begin_stroke(1, 2);
  woven.begin_stroke(0, 1);
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < b.size()) woven.stamp(1, b[i]);
    if (i < a.size()) woven.stamp(0, a[i]);
  }
  expect_same_bits(ordered.state(), woven.state());
}

TEST(Simulation, AStrokeLeavesTheCanvasAndComesBack) {
  const Threads threads(1);
  Simulation sim(setup_of(128, 2), threads);
  paint(sim,
        {{at(0.15, 0.05, 0), at(0.3, 0.05, 0.3), at(0.3, 0.2, 0.6), at(0.1, 0.1, 1)}, 0, 1, 0});
  EXPECT_EQ(sim.first_non_finite(), "");
  EXPECT_GT(sim.state().depth_m(127, static_cast<int>(0.05 / kHeight_m * 96)), 0.0f);
  const PaintAccount& account = sim.account();
  EXPECT_LT(
      imbalance(account.deposited.medium_m3, account.picked_up.medium_m3, 0, sim.wet().medium_m3),
      1e-13);
}

TEST(Simulation, ATapLaysHalfADiametersFilm) {
  const Threads threads(1);
  Simulation sim(setup_of(160, 2), threads);
  BrushSettings settings;
  settings.pickup = 0;  // what is lifted comes back
  sim.set_settings(settings);
  paint(sim, {{at(0.1, 0.07, 0)}, 0, 1, 0});
  // 1 mm of film over the diameter times half of it. The brush dries by 1/400 per diameter.
  const double expected = 1e-3 * 0.02 * 0.01;
  EXPECT_NEAR(sim.account().deposited.medium_m3, expected, 0.5 / 400 * expected);
  EXPECT_GT(sim.state().depth_m(80, 56), 0.0f);
}

TEST(Simulation, DepositStopsAtTheGreatestDepth) {
  const Threads threads(1);
  SimulationSetup setup = setup_of(64, 2);
  setup.model.max_medium_m = 0.003f;
  Simulation sim(std::move(setup), threads);
  for (std::uint32_t id = 1; id < 12; ++id)
    paint(sim, {{at(0.05, 0.07, 0), at(0.15, 0.07, 1)}, 0, id, 0});
  float deepest = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) deepest = std::max(deepest, sim.state().depth_m(x, y));
  EXPECT_LE(deepest, 0.003f);
  EXPECT_GT(deepest, 0.0029f);
}

TEST(Simulation, AClearStrokeOverColourDirtiesTheBrushAndRefillCleansIt) {
  const Threads threads(1);
  Simulation sim(setup_of(160, 2), threads);
  paint(sim, {{at(0.05, 0.02, 0), at(0.05, 0.13, 1)}, 1, 1, 0});
  paint(sim, {{at(0.02, 0.07, 0), at(0.18, 0.07, 1)}, 2, 2, 0});
  const CanvasState& s = sim.state();
  const auto red = [&](double x_m) {
    double sum = 0;
    for (int layer = 0; layer < 2; ++layer)
      sum += static_cast<double>(s.channel(layer, 1)(static_cast<int>(x_m * 800), 56));
    return sum;
  };
  EXPECT_GT(red(0.075), 1e-4);  // dragged on behind the red stroke
  // Four diameters on, at 40 % of the difference per diameter, 0.6^4.25 = 0.11 is left; what the
  // brush lifts of its own trail adds to it.
  EXPECT_LT(red(0.16), 0.25 * red(0.075));
  EXPECT_EQ(red(0.022), 0);  // clean before it
}

TEST(Simulation, ADryCanvasDriesTheBrushAWetOneDoesNot) {
  const Threads threads(1);
  const auto deposited = [&](bool wet) {
    SimulationSetup setup = setup_of(128, 2);
    Simulation sim(std::move(setup), threads);
    BrushSettings settings;
    settings.pickup = 0;
    sim.set_settings(settings);
    const StrokePlan there{{at(0.02, 0.07, 0), at(0.18, 0.07, 1)}, 0, 1, 0};
    if (wet)
      for (const double y : {0.055, 0.07, 0.085})
        paint(sim, {{at(0.005, y, 0), at(0.195, y, 1)}, 0, 9, 0});
    const double before = sim.account().deposited.medium_m3;
    StrokePlan second = there;
    second.id = 10;
    paint(sim, second);
    return sim.account().deposited.medium_m3 - before;
  };
  EXPECT_LT(deposited(false), 0.9925 * deposited(true));  // 8 diameters of 400: 1 % of the mean
}

TEST(Simulation, ATouchsSecondStrokeStartsAsItsFirst) {
  // The last pass ends on wet paint, where a brush dries no more. The stroke after it goes on under
  // the same id, so nothing lies ahead of it that says what it runs onto: a brush dipped again is
  // as good as another one.
  const Threads threads(1);
  const auto painted = [&](int second_touch) {
    Simulation sim(setup_of(128, 2), threads);
    for (std::uint32_t pass = 1; pass < 6; ++pass)
      paint(sim, {{at(0.02, 0.03, pass), at(0.18, 0.03, pass + 0.9)}, 0, pass, 0});
    paint(sim, {{at(0.04, 0.03, 6), at(0.14, 0.03, 6.9)}, 0, 7, 0});
    paint(sim, {{at(0.06, 0.03, 7), at(0.12, 0.03, 7.9)}, 0, 7, second_touch});
    return sim.wet();
  };
  const PaintFlow same = painted(0), other = painted(1);
  EXPECT_EQ(same.medium_m3, other.medium_m3);
  EXPECT_EQ(same.channel, other.channel);
}

TEST(Simulation, DryPaintSleepsWhateverGravityDoes) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2, SchemeKind::kConservative), threads);
  BrushSettings runny;
  runny.pigment_frac = 0.05f;
  sim.set_settings(runny);
  paint_crossing(sim);
  for (int i = 0; i < 2000 && sim.step(); ++i) continue;
  ASSERT_FALSE(sim.step());
  sim.dry();
  EXPECT_FALSE(sim.step());
  sim.set_gravity({0, 9.81f, 0});
  EXPECT_FALSE(sim.step());
}

TEST(Simulation, DryingMovesThePaintIntoTheCanvas) {
  const Threads threads(1);
  Simulation sim(setup_of(128, 2), threads);
  paint_crossing(sim);
  const PaintFlow wet = sim.wet();
  const double height_before = plane_sum(sim.state().depth_m) + plane_sum(sim.state().base_m);
  sim.dry();
  const CanvasState& s = sim.state();
  EXPECT_EQ(plane_sum(s.depth_m), 0);
  EXPECT_EQ(sim.wet().medium_m3, 0);
  EXPECT_EQ(sim.account().dried.medium_m3, wet.medium_m3);
  EXPECT_EQ(sim.account().dried.channel, wet.channel);
  EXPECT_NEAR(plane_sum(s.base_m) / height_before, 1, 1e-6);  // one float rounding per cell
  EXPECT_EQ(s.stroke(64, 48), 0u);
  EXPECT_LT(s.reflectance[0](32, 29), 0.5f);  // blue, no longer primer
  EXPECT_EQ(s.reflectance[1](2, 2), 0.9f);
}

TEST(Simulation, PaletteAndOpticalChannelsGiveTheSamePicture) {
  const Threads threads(1);
  SimulationSetup optical = setup_of(128, 3);
  optical.basis = optical_channels(test::three_pigments());
  Simulation a(setup_of(128, 3), threads), b(std::move(optical), threads);
  for (Simulation* sim : {&a, &b}) {
    paint_crossing(*sim);
    sim->dry();
  }
  EXPECT_NEAR(b.account().deposited.channel[0],
              a.account().deposited.channel[0] + a.account().deposited.channel[1] +
                  a.account().deposited.channel[2],
              1e-5 * b.account().deposited.channel[0]);
  // Both mix linearly; floats round differently in 3 and in 7 channels.
  for (std::size_t band = 0; band < 3; ++band)
    EXPECT_LT(
        relative_l2(a.state().reflectance[band].values(), b.state().reflectance[band].values()),
        1e-5);
}

TEST(Simulation, ASliderDuringAStrokeLoadsTheBrushAfresh) {
  const Threads threads(1);
  Simulation sim(setup_of(128, 2), threads);
  const auto stamps = stamps_of({at(0.03, 0.07, 0), at(0.17, 0.07, 1)});
  BrushSettings settings;
  settings.pickup = 0;  // what a brush has lifted is gone when it is loaded afresh
  sim.set_settings(settings);
  sim.begin_stroke(0, 1);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (i == stamps.size() / 2) {
      settings.medium_frac = 0.1f;
      sim.set_settings(settings);
    }
    sim.stamp(0, stamps[i]);
  }
  // Half the way with 1 mm, half with 0.2 mm, and nothing of the difference dumped between.
  const double expected = 0.07 * 0.02 * (1e-3 + 0.2e-3);
  EXPECT_NEAR((sim.account().deposited.medium_m3 - sim.account().picked_up.medium_m3) / expected, 1,
              0.03);  // drying of the brush: 1.75 %
}

TEST(Simulation, ABareCanvasOfSmoothPaperTakesNoMemory) {
  if (is_marked_when_given()) GTEST_SKIP();
  const Threads threads(1);
  SimulationSetup setup = setup_of(64, 2);
  setup.paper_m = {};
  setup.geometry.width = setup.geometry.height = 4096;  // planes of 64 MiB
  const long before_mib = resident_mib();
  Simulation sim(std::move(setup), threads);
  // Some fifty planes are there, of which a sanitizer has a shadow.
  const long most_mib = test::kStride == 1 ? 32 : 50 * 64 / 8;
  EXPECT_LT(resident_mib() - before_mib, most_mib);
  sim.clear();
  EXPECT_LT(resident_mib() - before_mib, most_mib);
}

TEST(Simulation, ALargeCanvasGivesBackWhatTheBrushUsedNowAndThen) {
  if (is_marked_when_given()) GTEST_SKIP();
  const Threads threads(2);
  Simulation sim(setup_of(2560, 1, SchemeKind::kConservative), threads);
  const auto touch_it_all = [&] {
    sim.begin_stroke(0, 1);
    Stamp stamp;
    stamp.x_m = 0.1;
    stamp.y_m = 0.075;
    stamp.diameter_m = 0.2f;
    stamp.pressure = 1;
    sim.stamp(0, stamp);
    sim.end_stroke(0);
    sim.step();
    return resident_mib();
  };
  sim.skip(kStepsBetweenGivingBack);
  const long given_back_mib = touch_it_all();
  // In the next step all else is there; of the contact's five planes of 19 MiB two thirds are used.
  EXPECT_GT(touch_it_all() - given_back_mib, 40);
}

TEST(Simulation, ClearGivesAFreshCanvasAndNewBooks) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  paint_crossing(sim);
  sim.step();
  sim.dry();
  sim.clear();
  Simulation fresh(setup_of(64, 2), threads);
  expect_same_bits(sim.state(), fresh.state());
  EXPECT_TRUE(
      same_bits(sim.state().reflectance[0].values(), fresh.state().reflectance[0].values()));
  EXPECT_EQ(sim.account().deposited.medium_m3, 0);
  EXPECT_EQ(sim.state().step, 1);
}

TEST(Simulation, AFreshCanvasSleeps_AndComesToTheSameState) {
  const Threads threads(1);
  for (const bool at_once : {false, true}) {
    const Vec3f gravity = at_once ? Vec3f{0, 0, 9.81f} : Vec3f{3, -6.9f, 6.2f};
    Simulation sleepy(setup_of(256, 2, SchemeKind::kConservative), threads);
    Simulation wakeful(setup_of(256, 2, SchemeKind::kConservative), threads);
    for (Simulation* sim : {&sleepy, &wakeful}) {
      Model model = sim->model();
      model.sleep_tile_m = static_cast<float>(kWidth_m) / 16;
      sim->set_model(model);
      sim->set_gravity(gravity);
    }
    // Three canvases: just made, dried, cleared. They are touched at once, or in the second step. A
    // state that was restored is computed everywhere.
    for (const int canvas : {0, 1, 2}) {
      if (canvas == 1) sleepy.dry(), wakeful.dry();
      if (canvas == 2) sleepy.clear(), wakeful.clear();
      wakeful.restore(clone_state(wakeful.state()));
      if (!at_once) {
        EXPECT_FALSE(sleepy.step());
        EXPECT_TRUE(wakeful.step());
        EXPECT_EQ(sleepy.state().sleep, wakeful.state().sleep) << canvas;
      }
      for (Simulation* sim : {&sleepy, &wakeful})
        paint(*sim, {{at(0.05, 0.07, 0), at(0.09, 0.08, 1)}, 0, 1, 0});
      for (int step = 0; step < 40; ++step) sleepy.step(), wakeful.step();
      expect_same_bits(sleepy.state(), wakeful.state());
      EXPECT_TRUE(same_bits(sleepy.state().velocity_y_m_s, wakeful.state().velocity_y_m_s));
      EXPECT_EQ(sleepy.state().sleep, wakeful.state().sleep) << canvas;
      EXPECT_FALSE(sleepy.state().sleep.empty());
    }
    const auto most_awake = [](const Simulation& sim) {
      for (const auto& [name, value] : sim.statistics())
        if (name == "awake_share_max") return value;
      return -1.0;
    };
    EXPECT_EQ(most_awake(wakeful), 1);
    if (!at_once) {
      EXPECT_LT(most_awake(sleepy), 0.5);
    }
  }
}

TEST(Simulation, WhatIsRecalledIsAsFreshAsItWas) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  for (const bool fresh : {true, false}) {
    EXPECT_EQ(sim.memory().fresh, fresh);
    Simulation twin(setup_of(64, 2), threads);
    if (fresh) twin.step();
    twin.recall(clone_state(sim.state()), sim.memory());
    EXPECT_EQ(twin.memory().fresh, fresh);
    sim.step();
  }
  sim.dry();
  EXPECT_TRUE(sim.memory().fresh);
}

TEST(Simulation, ALoadedImageIsTheDryLayer) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  paint_crossing(sim);
  std::vector<Field<float>> image;
  for (int band = 0; band < 3; ++band) image.emplace_back(64, 48, 0.1f * static_cast<float>(band));
  sim.load(image);
  EXPECT_EQ(sim.state().reflectance[2](30, 20), 0.2f);
  EXPECT_EQ(sim.wet().medium_m3, 0);
}

TEST(Simulation, ARestoredStateGoesOnAndItsPaintCountsAsDeposited) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  paint_crossing(sim);
  CanvasState state = make_canvas_state(sim.state().geometry, 2, 3, 3, 1);
  state.depth_m = sim.state().depth_m.clone();
  for (std::size_t i = 0; i < state.pigment.size(); ++i)
    state.pigment[i] = sim.state().pigment[i].clone();
  Simulation other(setup_of(64, 2), threads);
  other.restore(std::move(state));
  EXPECT_EQ(other.account().deposited.medium_m3, sim.wet().medium_m3);
  paint(other, {{at(0.03, 0.03, 0), at(0.1, 0.1, 1)}, 0, 7, 0});
  const PaintAccount& account = other.account();
  EXPECT_LT(
      imbalance(account.deposited.medium_m3, account.picked_up.medium_m3, 0, other.wet().medium_m3),
      1e-13);
}

TEST(Simulation, AnIdleStepSaysSoAndCountsAsSkipped) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  EXPECT_FALSE(sim.step());
  sim.skip(41);
  EXPECT_EQ(sim.state().step, 42);
  paint(sim, {{at(0.1, 0.07, 0)}, 0, 1, 0});
  EXPECT_TRUE(sim.step());
}

TEST(Simulation, NamesTheFirstNonFiniteValue) {
  const Threads threads(1);
  Simulation sim(setup_of(64, 2), threads);
  EXPECT_EQ(sim.first_non_finite(), "");
  CanvasState state = make_canvas_state(sim.state().geometry, 2, 3, 3, 1);
  state.depth_m(3, 4) = std::nanf("");
  sim.restore(std::move(state));
  EXPECT_EQ(sim.first_non_finite(), "depth at cell (3,4)");
}

TEST(Simulation, LooksForNonFiniteValuesInEveryPlane) {
  for (const int count : {1, 2, 7}) {
    const Threads threads(count);
    Simulation sim(setup_of(64, 2), threads);
    const CanvasGeometry geometry = sim.state().geometry;
    for (std::size_t plane = 0; plane < 6; ++plane) {
      CanvasState state = make_canvas_state(geometry, 2, 3, 3, 1);
      state.pigment[plane](geometry.width - 1, geometry.height - 1) = INFINITY;
      state.pigment[5](1, 0) = std::nanf("");  // the first in order is named
      sim.restore(std::move(state));
      const std::string place = plane == 5 ? "(1,0)"
                                           : "(" + std::to_string(geometry.width - 1) + "," +
                                                 std::to_string(geometry.height - 1) + ")";
      EXPECT_EQ(sim.first_non_finite(), "layer " + std::to_string(plane / 3) + " channel " +
                                            std::to_string(plane % 3) + " at cell " + place);
    }
  }
}

TEST(Simulation, TheSlidersAtZeroMakeABlender) {
  const Threads threads(1);
  Simulation sim(setup_of(128, 2), threads);
  paint(sim, {{at(0.1, 0.03, 0), at(0.1, 0.12, 1)}, 1, 1, 0});
  const double before = sim.wet().medium_m3;
  BrushSettings settings;
  settings.medium_frac = settings.pigment_frac = 0;
  sim.set_settings(settings);
  paint(sim, {{at(0.05, 0.07, 0), at(0.17, 0.07, 1)}, 1, 2, 0});
  const double after = sim.wet().medium_m3;
  EXPECT_LE(after, before * (1 + 1e-6));
  EXPECT_GT(after, before * 0.98);  // what it lifted it has laid again, but for a last remainder
  double carried = 0;
  for (int layer = 0; layer < 2; ++layer)
    carried += static_cast<double>(sim.state().channel(layer, 1)(static_cast<int>(0.12 * 640), 45));
  EXPECT_GT(carried, 1e-5);
}

TEST(Simulation, DryingASecondTimeKeepsTheReliefOfTheFirst) {
  const Threads threads(1);
  Simulation sim(setup_of(128, 2), threads);
  for (int times = 0; times < 2; ++times) {
    paint_crossing(sim);
    const float height_m = sim.state().base_m(32, 29) + sim.state().depth_m(32, 29);
    ASSERT_GT(sim.state().depth_m(32, 29), 0.0f);
    sim.dry();
    EXPECT_FLOAT_EQ(sim.state().base_m(32, 29), height_m) << times;
  }
}

}  // namespace
}  // namespace pentimento
