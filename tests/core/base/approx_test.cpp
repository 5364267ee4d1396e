#include "core/base/approx.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pentimento {
namespace {

constexpr int kSamples = 20000;

/// Largest distance between the two functions on [low, high], in units of the last place of `want`.
template <typename T>
double worst_ulp(const std::function<T(T)>& got, const std::function<T(T)>& want, T low, T high) {
  double worst = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const T x = low + (high - low) * (static_cast<T>(i) / kSamples);
    const T w = want(x);
    const T a = std::abs(w);
    const T ulp = std::nextafter(a, std::numeric_limits<T>::infinity()) - a;
    worst = std::max(worst, static_cast<double>(std::abs(got(x) - w) / ulp));
  }
  return worst;
}

double worst(double (*got)(double), double (*want)(double), double low, double high) {
  return worst_ulp<double>(got, want, low, high);
}

// 4 ulp: a few roundings of reduction, polynomial and scaling; the header promises it.
constexpr double kUlp = 4;

TEST(Approx, ExponentialsAreWithinFourUlp) {
  EXPECT_LE(worst(approx::exp, std::exp, -700, 709), kUlp);
  EXPECT_LE(worst(approx::exp, std::exp, -1, 1), kUlp);
  EXPECT_LE(worst(approx::exp2, std::exp2, -1000, 1000), kUlp);
  EXPECT_LE(worst(approx::expm1, std::expm1, -1, 1), kUlp);
  EXPECT_LE(worst(approx::expm1, std::expm1, -1e-9, 1e-9), kUlp);
}

TEST(Approx, LogarithmsAreWithinFourUlp) {
  EXPECT_LE(worst(approx::log, std::log, 1e-300, 2), kUlp);
  EXPECT_LE(worst(approx::log, std::log, 0.99, 1.01), kUlp);
  EXPECT_LE(worst(approx::log, std::log, 1, 1e300), kUlp);
  EXPECT_LE(worst(approx::log2, std::log2, 0.001, 100), kUlp);
  EXPECT_LE(worst(approx::log1p, std::log1p, -0.9, 3), kUlp);
  EXPECT_LE(worst(approx::log1p, std::log1p, -1e-9, 1e-9), kUlp);
}

TEST(Approx, HyperbolicsAreWithinFourUlp) {
  EXPECT_LE(worst(approx::tanh, std::tanh, -25, 25), kUlp);
  EXPECT_LE(worst(approx::tanh, std::tanh, -0.01, 0.01), kUlp);
  EXPECT_LE(worst(approx::sinh, std::sinh, -3, 3), kUlp);
  EXPECT_LE(worst(approx::cosh, std::cosh, -3, 3), kUlp);
}

TEST(Approx, SineAndCosineAreAbsolutelyAccurate) {
  // 3e-16: a polynomial rounding or two of a result of at most 1.
  for (double range : {1.0, 10.0, 1e3, 1e6})
    for (int i = -kSamples; i <= kSamples; ++i) {
      const double x = range * i / kSamples;
      ASSERT_NEAR(approx::sin(x), std::sin(x), 3e-16) << x;
      ASSERT_NEAR(approx::cos(x), std::cos(x), 3e-16) << x;
    }
}

TEST(Approx, AnglesAreWithinFourUlpInEveryQuadrant) {
  for (int i = 0; i < kSamples; ++i) {
    const double angle = 6.28 * i / kSamples;
    const double y = 3 * std::sin(angle), x = 3 * std::cos(angle);
    const double want = std::atan2(y, x);
    ASSERT_NEAR(approx::atan2(y, x), want, kUlp * 2.3e-16 * std::abs(want)) << angle;
  }
  EXPECT_EQ(approx::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(approx::atan2(0.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(approx::atan2(0.0, -1.0), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(approx::atan2(-1.0, 0.0), -1.57079632679489661923);
}

TEST(Approx, PowersFollowTheStatedBound) {
  for (double y : {-2.5, -1.0, 1.0 / 2.4, 0.5, 2.0, 2.4, 7.0})
    for (int i = 1; i <= 2000; ++i) {
      const double x = 1e-3 * i * i;
      const double want = std::pow(x, y);
      const double bound = 1e-15 * (1 + std::abs(y * std::log(x)));
      ASSERT_NEAR(approx::pow(x, y), want, bound * want) << x << "^" << y;
    }
  EXPECT_EQ(approx::pow(0.0, 2.0), 0.0);
  EXPECT_EQ(approx::pow(5.0, 0.0), 1.0);
}

TEST(Approx, FloatsAreWithinOneUlp) {
  const auto check = [](float (*got)(float), double (*want)(double), float low, float high) {
    const auto rounded = [want](float x) { return static_cast<float>(want(x)); };
    EXPECT_LE(worst_ulp<float>(got, rounded, low, high), 1.0);
  };
  check(approx::exp, std::exp, -80, 80);
  check(approx::exp2, std::exp2, -120, 120);
  check(approx::expm1, std::expm1, -1, 1);
  check(approx::log, std::log, 1e-30f, 10);
  check(approx::log1p, std::log1p, -0.5f, 10);
  check(approx::sin, std::sin, -3, 3);
  check(approx::cos, std::cos, -1.5f, 1.5f);
  check(approx::tanh, std::tanh, -5, 5);
}

TEST(Approx, ExtremesAndInvalidArgumentsAreDefined) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(approx::exp(1000.0), inf);
  EXPECT_EQ(approx::exp(-1000.0), 0.0);
  EXPECT_EQ(approx::exp(-inf), 0.0);
  EXPECT_EQ(approx::exp(0.0), 1.0);
  EXPECT_NEAR(approx::exp(-740.0), std::exp(-740.0), 1e-323);  // two steps of the subnormals
  EXPECT_EQ(approx::log(0.0), -inf);
  EXPECT_EQ(approx::log(1.0), 0.0);
  EXPECT_TRUE(std::isnan(approx::log(-1.0)));
  EXPECT_DOUBLE_EQ(approx::log(1e-310), std::log(1e-310));
  EXPECT_TRUE(std::isnan(approx::exp(std::nan(""))));
  EXPECT_TRUE(std::isnan(approx::sin(std::nan(""))));
  EXPECT_TRUE(std::isnan(approx::sin(inf)));
}

TEST(Approx, WholePowersOfTwoAreExact) {
  for (int k = -1022; k <= 1023; ++k) {
    const double two_k = approx::exp2(static_cast<double>(k));
    EXPECT_EQ(two_k, std::ldexp(1.0, k));
    EXPECT_EQ(approx::log2(two_k), k);
  }
}

}  // namespace
}  // namespace pentimento
