#include "formats/log/edit/spline_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/brush/stroke_path.h"

namespace pentimento::log {
namespace {

/// A sample each 10 ms at f(share of the way).
template <typename F>
std::vector<TimedTouch> stroke(int count, F f) {
  std::vector<TimedTouch> out;
  for (int i = 0; i < count; ++i) {
    TimedTouch sample;
    sample.time_us = 10'000 * i;
    f(static_cast<double>(i) / (count - 1), sample.touch);
    out.push_back(sample);
  }
  return out;
}
std::vector<std::size_t> kept(std::vector<TimedTouch> samples) {
  keep_for_spline(samples, {});
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].keep) out.push_back(i);
  return out;
}

TEST(SplineFit, AnEvenLineNeedsItsEnds) {
  EXPECT_EQ(kept(stroke(100,
                        [](double s, Touch& t) {
                          t.x_m = s;
                          t.pressure = 0.2 + 0.6 * s;
                          t.tilt_x_deg = -20 + 40 * s;
                        })),
            (std::vector<std::size_t>{0, 99}));
  EXPECT_EQ(kept({}).size(), 0u);
  EXPECT_EQ(kept(stroke(2, [](double s, Touch& t) { t.x_m = s; })).size(), 2u);
}

TEST(SplineFit, EachPropertyThatTurnsIsKept) {
  const auto turning = [](double s) { return s < 0.5 ? 0.2 + s : 1.2 - s; };
  for (int property = 0; property < 5; ++property) {
    const auto samples = stroke(101, [&](double s, Touch& t) {
      t.x_m = s;
      if (property == 0) t.pressure = turning(s);
      if (property == 1) t.tilt_x_deg = 90 * turning(s);
      if (property == 2) t.tilt_y_deg = 90 * turning(s);
      if (property == 3) t.twist_deg = 90 * turning(s);
      if (property == 4) t.radius_m = 0.01 * turning(s);
    });
    EXPECT_EQ(kept(samples), (std::vector<std::size_t>{0, 50, 100})) << property;
  }
}

TEST(SplineFit, APauseAndWhatMustStayStays) {
  // Half a second on one spot.
  const auto samples = stroke(101, [](double s, Touch& t) {
    t.x_m = s < 0.25 ? s : s < 0.75 ? 0.25 : s - 0.5;
  });
  const std::vector<std::size_t> out = kept(samples);
  EXPECT_EQ(out, (std::vector<std::size_t>{0, 25, 75, 100}));
  auto forced = stroke(11, [](double s, Touch& t) { t.x_m = s; });
  forced[3].keep = true;
  EXPECT_EQ(kept(forced), (std::vector<std::size_t>{0, 3, 10}));
}

/// Where the painter stamps.
std::vector<Stamp> stamps_of(const std::vector<TimedTouch>& samples, bool all) {
  StrokePath path(0.02, 1, 1);
  std::vector<Stamp> out;
  bool begun = false;
  for (const TimedTouch& s : samples) {
    if (!all && !s.keep) continue;
    TouchSample sample;
    sample.x_m = s.touch.x_m;
    sample.y_m = s.touch.y_m;
    sample.time_s = static_cast<double>(s.time_us) * 1e-6;
    sample.pressure = static_cast<float>(*s.touch.pressure);
    if (begun)
      path.add(sample, out);
    else
      path.begin(sample);
    begun = true;
  }
  path.finish(out);
  return out;
}

// A spiral with a swelling pressure: the painter's own path through a fifth of the samples is the
// path through all, to the tolerance and a fifth more, for between the samples nothing is promised.
TEST(SplineFit, ThePainterDrawsTheSameStroke) {
  auto samples = stroke(600, [](double s, Touch& t) {
    const double r = 0.1 + 0.3 * s, a = 15 * s;
    t.x_m = 0.5 + r * std::cos(a);
    t.y_m = 0.5 + r * std::sin(a);
    t.pressure = 0.5 + 0.4 * std::sin(9 * s);
  });
  keep_for_spline(samples, {});
  const auto count =
      std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s.keep; });
  EXPECT_LT(count, 120);
  const std::vector<Stamp> full = stamps_of(samples, true), thin = stamps_of(samples, false);
  double worst_m = 0, worst_pressure = 0;
  for (const Stamp& stamp : thin) {
    const Stamp* nearest = &full.front();
    const auto away = [&](const Stamp& s) {
      return std::hypot(s.x_m - stamp.x_m, s.y_m - stamp.y_m);
    };
    for (const Stamp& s : full)
      if (away(s) < away(*nearest)) nearest = &s;
    // Across the path: along it, the next stamp is up to half a spacing away.
    const double across =
        std::abs((nearest->x_m - stamp.x_m) * static_cast<double>(stamp.direction.y) -
                 (nearest->y_m - stamp.y_m) * static_cast<double>(stamp.direction.x));
    worst_m = std::max(worst_m, across);
    worst_pressure =
        std::max(worst_pressure, std::abs(static_cast<double>(nearest->pressure - stamp.pressure)));
  }
  EXPECT_LT(worst_m, 6e-4);
  EXPECT_LT(worst_pressure, 0.03);
}

}  // namespace
}  // namespace pentimento::log
