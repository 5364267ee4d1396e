#include "core/optics/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pentimento {
namespace {
constexpr double kN = 1.48;  // linseed oil
double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
std::array<double, 3> direction(double theta, double phi = 0) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TEST(Fresnel, ExactAndSchlickMeetReferenceValues) {
  const double cases[][3] = {{0, .037461, .037461},  {30, .038940, .037503},
                             {45, .047456, .039536}, {60, .085844, .067540},
                             {75, .249198, .252759}, {85, .610453, .647562}};
  const double f0 = fresnel_normal(kN);
  EXPECT_NEAR(f0, .037460978, 5e-10);
  for (const auto& [angle, exact, schlick] : cases) {
    EXPECT_NEAR(fresnel(std::cos(radians(angle)), kN), exact, 5.1e-7) << angle;  // six digits
    EXPECT_NEAR(fresnel_schlick(std::cos(radians(angle)), f0), schlick, 5.1e-7) << angle;
  }
  EXPECT_DOUBLE_EQ(fresnel(0, kN), 1);
}

/// Integral over the hemisphere by the midpoint rule in cos(theta) and phi.
double integral(int steps, auto&& value) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) / steps * std::numbers::pi / 2;
    for (int j = 0; j < steps; ++j) {
      const double phi = (j + 0.5) / steps * std::numbers::pi;  // even in phi: half the turn, twice
      sum += value(theta, phi) * std::sin(theta);
    }
  }
  return 2 * sum * (std::numbers::pi / 2 / steps) * (std::numbers::pi / steps);
}

TEST(FacetDensity, IsNormalised) {
  for (const auto kind : {FacetDistribution::kBeckmann, FacetDistribution::kGgx}) {
    for (const double a : {0.05, 0.2, 0.5, 1.0}) {
      double sum = 0;
      constexpr int kSteps = 20000;
      for (int i = 0; i < kSteps; ++i) {
        const double theta = (i + 0.5) / kSteps * std::numbers::pi / 2;
        sum += facet_density(kind, std::cos(theta), a) * std::cos(theta) * std::sin(theta);
      }
      EXPECT_NEAR(sum * 2 * std::numbers::pi * std::numbers::pi / 2 / kSteps, 1, 1e-6)
          << a;  // midpoint rule
    }
  }
}

TEST(TorranceSparrow, MeetsReferenceValuesSeenFromAbove) {
  const double cases[][2] = {
      {0, .07452624807}, {20, .03877242029}, {40, .004579009165}, {60, 6.6207928e-5}};
  for (const auto& [angle, f] : cases) {
    EXPECT_NEAR(torrance_sparrow(FacetDistribution::kBeckmann, .2, kN, direction(radians(angle)),
                                 {0, 0, 1}),
                f, 1e-9 * 0.1)
        << angle;  // eight to ten digits
  }
  EXPECT_NEAR(facet_density(FacetDistribution::kBeckmann, 1, .2), 7.957747, 5e-7);
  EXPECT_EQ(groove_attenuation(1, 1, 1, 1), 1);
}

TEST(TorranceSparrow, IsReciprocalToTheLastBit) {
  for (int i = 0; i < 500; ++i) {
    const auto l = direction(0.003 * i, 1.7 * i), v = direction(1.55 - 0.0031 * i, 2.9 * i);
    for (const auto kind : {FacetDistribution::kBeckmann, FacetDistribution::kGgx}) {
      EXPECT_EQ(torrance_sparrow(kind, .25, kN, l, v), torrance_sparrow(kind, .25, kN, v, l));
    }
  }
}

TEST(TorranceSparrow, IsDarkBelowTheHorizon) {
  EXPECT_EQ(torrance_sparrow(FacetDistribution::kBeckmann, .3, kN, direction(1.6), {0, 0, 1}), 0);
  EXPECT_EQ(torrance_sparrow(FacetDistribution::kBeckmann, .3, kN, {0, 0, 1}, direction(1.6)), 0);
}

struct Furnace {
  FacetDistribution kind;
  double a, angle, albedo;
};
TEST(FacetLobe, ReflectsTheReferenceShareOfAWhiteFurnaceAndNeverMoreThanAll) {
  constexpr auto kBeckmann = FacetDistribution::kBeckmann;
  constexpr auto kGgx = FacetDistribution::kGgx;
  constexpr Furnace kCases[] = {
      {kBeckmann, .1, 0, 1.0000}, {kBeckmann, .3, 0, .9956},  {kBeckmann, .5, 0, .8924},
      {kBeckmann, .1, 60, .9991}, {kBeckmann, .3, 60, .9248}, {kBeckmann, .5, 60, .8869},
      {kBeckmann, .1, 80, .9417}, {kBeckmann, .3, 80, .9449}, {kBeckmann, .5, 80, .9551},
      {kGgx, .1, 0, .9826},       {kGgx, .3, 0, .8640},       {kGgx, .5, 0, .6992},
  };
  for (const Furnace& c : kCases) {
    const auto v = direction(radians(c.angle));
    const double albedo = integral(300, [&](double theta, double phi) {
      return facet_lobe(c.kind, c.a, direction(theta, phi), v) * std::cos(theta);
    });
    EXPECT_NEAR(albedo, c.albedo, 3e-4) << c.a << " at " << c.angle;  // 0.3 degree steps
    EXPECT_LE(albedo, 1 + 3e-4);
  }
}

TEST(TorranceSparrow, OfOilReflectsTheReferenceShare) {
  const double cases[][2] = {{0, .037508}, {60, .083268}, {80, .247940}};
  for (const auto& [angle, albedo] : cases) {
    const auto v = direction(radians(angle));
    const double sum = integral(300, [&](double theta, double phi) {
      return torrance_sparrow(FacetDistribution::kBeckmann, .2, kN, direction(theta, phi), v) *
             std::cos(theta);
    });
    EXPECT_NEAR(sum, albedo, 1e-4) << angle;
  }
}

}  // namespace
}  // namespace pentimento
