#include "core/brush/stroke_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pentimento {
namespace {

constexpr double kSpacing = 0.025;

TouchSample sample_at(double x_m, double y_m, double time_s, float diameter_m = 0.03f) {
  TouchSample s;
  s.x_m = x_m;
  s.y_m = y_m;
  s.time_s = time_s;
  s.diameter_m = diameter_m;
  return s;
}

std::vector<Stamp> stamps_of(const std::vector<TouchSample>& samples) {
  StrokePath path(kSpacing, 1.0, 0.75);
  std::vector<Stamp> out;
  path.begin(samples.front());
  for (std::size_t i = 1; i < samples.size(); ++i) path.add(samples[i], out);
  path.finish(out);
  return out;
}

/// One second of a loop 0.3 m wide, as a device of `rate_Hz` would see it.
std::vector<Stamp> loop(int rate_Hz) {
  std::vector<TouchSample> samples;
  for (int i = 0; i <= rate_Hz; ++i) {
    const double t = static_cast<double>(i) / rate_Hz;
    TouchSample s = sample_at(0.5 + 0.15 * std::cos(5 * t), 0.35 + 0.15 * std::sin(5 * t), t);
    s.pressure = static_cast<float>(0.5 + 0.4 * std::sin(3 * t));
    samples.push_back(s);
  }
  return stamps_of(samples);
}

double travel_sum(const std::vector<Stamp>& stamps) {
  double sum = 0;
  for (const Stamp& s : stamps) sum += static_cast<double>(s.travel_m);
  return sum;
}

TEST(StrokePath, SpacesStampsEvenlyOnAStraightLine) {
  // 0.3 m at 0.025 x 0.03 m: 400 stamps, whatever the uneven samples. The diameter is a float: over
  // 400 stamps its rounding sums to 1e-8 m.
  const auto stamps = stamps_of({sample_at(0.1, 0.2, 0), sample_at(0.1305, 0.2, 0.1),
                                 sample_at(0.31, 0.2, 0.2), sample_at(0.4, 0.2, 0.3)});
  ASSERT_NEAR(static_cast<double>(stamps.size()), 400, 1);
  for (std::size_t i = 0; i + 1 < stamps.size(); ++i) {
    EXPECT_NEAR(stamps[i].x_m, 0.1 + 0.00075 * static_cast<double>(i + 1), 1e-7);
    EXPECT_NEAR(stamps[i].y_m, 0.2, 1e-12);
    EXPECT_NEAR(stamps[i].travel_m, 0.00075f, 1e-8f);
    EXPECT_FLOAT_EQ(stamps[i].direction.x, 1.0f);
  }
}

TEST(StrokePath, PassesThroughItsSamples) {
  const std::vector<TouchSample> samples = {sample_at(0.1, 0.1, 0), sample_at(0.2, 0.15, 0.1),
                                            sample_at(0.25, 0.3, 0.2), sample_at(0.4, 0.3, 0.3)};
  const auto stamps = stamps_of(samples);
  for (const TouchSample& s : samples) {
    double nearest = 1;
    for (const Stamp& stamp : stamps)
      nearest = std::min(nearest, std::hypot(stamp.x_m - s.x_m, stamp.y_m - s.y_m));
    EXPECT_LT(nearest, kSpacing * 0.03);  // a stamp within one spacing of every sample
  }
}

TEST(StrokePath, DoesNotDependOnTheRateOfTheDevice) {
  const auto slow = loop(30);
  const auto fast = loop(240);
  ASSERT_NEAR(static_cast<double>(slow.size()), static_cast<double>(fast.size()), 1);
  const std::size_t n = std::min(slow.size(), fast.size()) - 1;
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    worst =
        std::max(worst, std::hypot(slow[i].x_m - fast[i].x_m, slow[i].y_m - fast[i].y_m) / 0.03);
    EXPECT_NEAR(slow[i].pressure, fast[i].pressure, 0.01);
    EXPECT_NEAR(slow[i].time_s, fast[i].time_s, 0.003);
  }
  // A twentieth of the spacing's own size would be 1e-3 of the diameter; the reflected ends of the
  // 30 Hz stroke, where the curvature is unknown, reach 1e-2.
  EXPECT_LT(worst, 1.5e-2);
}

TEST(StrokePath, LaysEqualTravelAtAnySpacing) {
  const std::vector<TouchSample> samples = {sample_at(0.1, 0.1, 0), sample_at(0.3, 0.2, 0.2),
                                            sample_at(0.2, 0.4, 0.4)};
  double reference = 0;
  for (const double spacing : {0.01, 0.02, 0.03, 0.05, 0.1}) {
    StrokePath path(spacing, 1.0, 0.75);
    std::vector<Stamp> out;
    path.begin(samples[0]);
    for (std::size_t i = 1; i < samples.size(); ++i) path.add(samples[i], out);
    path.finish(out);
    if (reference == 0) reference = travel_sum(out);
    // Chords of a quarter of the spacing cut corners by less than 1e-3 of the arc.
    EXPECT_NEAR(travel_sum(out) / reference, 1.0, 1e-3);
  }
}

TEST(StrokePath, ATapIsADabOfHalfADiameterToAllSides) {
  const auto stamps = stamps_of({sample_at(0.3, 0.2, 1.0), sample_at(0.3, 0.2, 1.1)});
  ASSERT_EQ(stamps.size(), 12u);
  Vec2f sum;
  for (const Stamp& s : stamps) {
    EXPECT_EQ(s.x_m, 0.3);
    EXPECT_EQ(s.y_m, 0.2);
    EXPECT_EQ(s.time_s, 1.1);
    EXPECT_FLOAT_EQ(s.travel_m, 0.015f / 12);
    EXPECT_EQ(s.direction.x, 0.0f);
    EXPECT_EQ(s.heading.x, 0.0f);
    EXPECT_NEAR(s.dab.x * s.dab.x + s.dab.y * s.dab.y, 1, 1e-6f);
    sum = {sum.x + s.dab.x, sum.y + s.dab.y};
  }
  for (int i = 0; i < 12; ++i) {  // each 30 degrees on from the one before
    const Vec2f a = stamps[static_cast<std::size_t>(i)].dab;
    const Vec2f b = stamps[static_cast<std::size_t>((i + 1) % 12)].dab;
    EXPECT_NEAR(a.x * b.y - a.y * b.x, 0.5, 1e-6);
  }
  EXPECT_NEAR(sum.x, 0, 1e-6f);
  EXPECT_NEAR(sum.y, 0, 1e-6f);
}

TEST(StrokePath, AStrokeOfADiameterHasNoDab) {
  for (const Stamp& s : stamps_of({sample_at(0.3, 0.2, 0), sample_at(0.33, 0.2, 0.1)}))
    EXPECT_TRUE(s.dab.x == 0 && s.dab.y == 0);
}

TEST(StrokePath, AShortTouchLaysNoLessThanATap) {
  const auto stamps = stamps_of({sample_at(0.3, 0.2, 0), sample_at(0.305, 0.2, 0.1)});
  EXPECT_NEAR(travel_sum(stamps), 0.015, 1e-6);  // float sums of seven stamps
}

TEST(StrokePath, PausesChangePressureNotThePath) {
  std::vector<TouchSample> samples;
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 5; ++k) {  // every place reported five times, 1 s apart
      samples.push_back(sample_at(0.1 + 0.01 * i, 0.3, 5.0 * i + k));
      samples.back().pressure = static_cast<float>(0.1 * i + 0.02 * k);
    }
  }
  const auto stamps = stamps_of(samples);
  EXPECT_NEAR(travel_sum(stamps), 0.09, 1e-6);
  for (const Stamp& s : stamps) EXPECT_TRUE(std::isfinite(s.x_m) && std::isfinite(s.pressure));
  // Between two places the brush moves for one second, from the fifth report to the next first.
  EXPECT_NEAR(stamps.front().time_s, 4.0 + 0.075, 0.02);
  EXPECT_NEAR(stamps.front().velocity_m_s.x, 0.01f, 1e-3f);
}

TEST(StrokePath, AJumpAcrossTheWorldStampsOnlyTheCanvas) {
  for (const double far : {1e3, 1e9, 1e100}) {
    const auto stamps =
        stamps_of({sample_at(-far, 0.3, 0), sample_at(far, 0.3, 1), sample_at(0.5, 0.3, 2)});
    EXPECT_LT(stamps.size(), 5000u);  // twice across 1 m of canvas at 0.75 mm, and the way in
    for (const Stamp& s : stamps) {
      EXPECT_GE(s.x_m, -0.0301);
      EXPECT_LE(s.x_m, 1.0301);
      EXPECT_TRUE(std::isfinite(s.travel_m));
    }
  }
}

TEST(StrokePath, ReachesTheFootOfATallCanvas) {
  StrokePath path(kSpacing, 0.5, 1.5);
  std::vector<Stamp> stamps;
  path.begin(sample_at(0.1, 1.4, 0));
  path.add(sample_at(0.4, 1.4, 1), stamps);
  path.finish(stamps);
  EXPECT_NEAR(travel_sum(stamps), 0.3, 1e-6);
}

TEST(StrokePath, LeavesAndComesBackWhereItShould) {
  const auto stamps = stamps_of({sample_at(0.9, 0.3, 0), sample_at(1.5, 0.3, 1),
                                 sample_at(1.5, 0.5, 2), sample_at(0.9, 0.5, 3)});
  EXPECT_NEAR(stamps.front().y_m, 0.3, 0.01);
  EXPECT_NEAR(stamps.back().x_m, 0.9, 1e-9);
  for (const Stamp& s : stamps) EXPECT_LE(s.x_m, 1.031);
}

/// On a canvas that holds all of the way, and on one that holds its last part alone.
TEST(StrokePath, AWayThatIsFarFromTheCanvasMovesTheBrushOnAsANearOneDoes) {
  std::vector<Stamp> stamps[2];
  for (const int small : {0, 1}) {
    StrokePath path(kSpacing, small ? 0.5 : 20, small ? 0.5 : 20);
    path.begin(sample_at(0.2, 15, 0));
    for (int i = 1; i < 60; ++i)
      path.add(sample_at(0.2 + 0.07 * (i % 3), 15 - 0.25 * i, 0.1 * i), stamps[small]);
    path.finish(stamps[small]);
  }
  ASSERT_GT(stamps[1].size(), 100u);
  ASSERT_GT(stamps[0].size(), 10 * stamps[1].size());
  for (std::size_t i = 1; i < 100; ++i) {
    const Stamp& a = stamps[0][stamps[0].size() - i];
    const Stamp& b = stamps[1][stamps[1].size() - i];
    EXPECT_NEAR(a.x_m, b.x_m, 1e-12) << i;
    EXPECT_NEAR(a.y_m, b.y_m, 1e-12) << i;
  }
}

TEST(StrokePath, TheHeadingDoesNotTurnRoundWhenPulledBack) {
  std::vector<TouchSample> samples;
  for (int i = 0; i <= 20; ++i) samples.push_back(sample_at(0.2 + 0.005 * i, 0.3, 0.01 * i));
  // Not quite along the same line: a heading that follows the direction itself would swing round.
  for (int i = 1; i <= 20; ++i)
    samples.push_back(sample_at(0.3 - 0.005 * i, 0.3 + 0.0005 * i, 0.2 + 0.01 * i));
  const auto stamps = stamps_of(samples);
  EXPECT_LT(stamps.back().direction.x, -0.99f);
  for (const Stamp& s : stamps) EXPECT_GT(s.heading.x, 0.99f);
}

TEST(StrokePath, TwistTakesTheShortWay) {
  TouchSample a = sample_at(0.2, 0.3, 0);
  TouchSample b = sample_at(0.3, 0.3, 1);
  a.twist_rad = 6.2f;
  b.twist_rad = 0.1f;
  for (const Stamp& s : stamps_of({a, b})) EXPECT_TRUE(s.twist_rad > 6.1f || s.twist_rad < 0.2f);
  std::swap(a.twist_rad, b.twist_rad);
  for (const Stamp& s : stamps_of({a, b})) EXPECT_TRUE(s.twist_rad > 6.1f || s.twist_rad < 0.2f);
}

TEST(StrokePath, AMissingPressureIsThatOfTheOtherEnd) {
  TouchSample with = sample_at(0.2, 0.3, 0), without = sample_at(0.3, 0.3, 1);
  with.pressure = 0.4f;
  std::vector<Stamp> stamps = stamps_of({with, without});
  stamps.pop_back();  // the last stands where nothing is known
  for (const Stamp& s : stamps) EXPECT_EQ(s.pressure, 0.4f);
  for (const Stamp& s : stamps_of({without, with})) EXPECT_EQ(s.pressure, 0.4f);
}

}  // namespace
}  // namespace pentimento
