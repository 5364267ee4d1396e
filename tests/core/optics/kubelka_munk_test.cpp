// Values: computed in high precision from the formulas of Curtis et al. 1997 and independently from
// the layer's differential equation; painty's example as published with that program. 1e-12: ten
// times the rounding error of the longest expression here.
#include "core/optics/kubelka_munk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

namespace pentimento {
namespace {

constexpr double kTolerance = 1e-12;
void expect_relative(double value, double expected, double tolerance = kTolerance) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

struct InverseCase {
  double over_white, over_black, K, S;
};
constexpr InverseCase kInverse[] = {
    {.5, .2, .380172998150473, .380172998150473},
    {.8, .4, .118462953758099, .789753025053993},
    {.9, .1, .0528985881281841, .117552418062631},
    {.95, .9, .0314730003478983, 11.3302801252434},
    {.2, .05, .864207613931021, .113711528148819},
    {.6, .599, .868195313539348, 6.48440140660934},
    {.1, .001, 1.15425213190303, .00256757230987216},
    {.99, .01, .0050253388432782, .0101521996833903},
    {.3, 1e-6, .601986848869546, 1.7199641453057e-6},
    {.7, .6999, .80027810103498, 12.4428444499474},
};

TEST(KubelkaMunkInverse, MeetsReferenceValues) {
  for (const InverseCase& c : kInverse) {
    const KmCoefficients km = km_from_white_black(c.over_white, c.over_black);
    // The two near-equal pairs lose what over_white - over_black loses as decimal input.
    const double tolerance = c.over_white - c.over_black < 2e-3 ? 1e-11 : kTolerance;
    expect_relative(km.K, c.K, tolerance);
    expect_relative(km.S, c.S, tolerance);
  }
}

TEST(KubelkaMunkInverse, ForwardReturnsTheColoursItCameFrom) {
  for (const InverseCase& c : kInverse) {
    const KmFilm film = km_film(km_from_white_black(c.over_white, c.over_black), 1);
    expect_relative(film.R, c.over_black, 1e-11);
    expect_relative(film.T, std::sqrt((c.over_white - c.over_black) * (1 - c.over_black)), 1e-9);
    expect_relative(km_over(film, 1), c.over_white, 1e-11);
  }
}

TEST(KubelkaMunkInverse, NonAbsorbingPaintIsTheExactLimit) {
  const KmCoefficients km = km_from_white_black(1, 0.3);
  EXPECT_EQ(km.K, 0);
  expect_relative(km.S, 0.3 / 0.7);
}

TEST(KubelkaMunkInverse, NonScatteringPaintTendsToItsLimit) {
  const double w = 0.4, b = 1e-15;  // where the published form is a per cent off
  const KmCoefficients km = km_from_white_black(w, b);
  expect_relative(km.S, -b * std::log(w) / (1 - w));
  expect_relative(km.K, -std::log(w) / 2);
}

struct ForwardCase {
  double K, S, x, R, T;
};
TEST(KubelkaMunkFilm, MeetsReferenceValues) {
  constexpr ForwardCase kCases[] = {
      {.22, .05, 1, .0386590785300892, .764183535695341},
      {1.47, .003, 1, .000964817952146748, .229237217452957},
      {.46, 1.28, 1, .404402516233702, .253124582223401},
      {0, 1, 3, .75, .25},
      {1, 0, 2, 0, .135335283236613},
      {.1, 1, 100, .641742430504416, 7.37270786062774e-21},
      {.5, .5, .25, .0987692257079014, .784014322009065},
  };
  for (const ForwardCase& c : kCases) {
    const KmFilm film = km_film({c.K, c.S}, c.x);
    expect_relative(film.R, c.R);
    expect_relative(film.T, c.T, 2e-12);  // given with 12 to 15 digits
  }
  const KmFilm thick = km_film({5, 5}, 50);  // exp(-433): nothing overflows
  expect_relative(thick.R, .267949192431123);
  expect_relative(thick.T, 8.177e-189, 1e-3);  // given with four digits
}

TEST(KubelkaMunkFilm, HasItsLimitsWithoutScatteringAndWithoutAbsorption) {
  for (const double x : {0.0, 1e-9, 0.3, 7.0}) {
    const KmFilm dark = km_film({0.8, 0}, x);
    EXPECT_EQ(dark.R, 0);
    expect_relative(dark.T, std::exp(-0.8 * x));
    const KmFilm white = km_film({0, 0.8}, x);
    EXPECT_NEAR(white.R, 0.8 * x / (1 + 0.8 * x), kTolerance);
    expect_relative(white.T, 1 / (1 + 0.8 * x));
  }
}

TEST(KubelkaMunkFilm, HalvesStackToTheWhole) {
  const KmFilm half = km_film({.4, .7}, .5);
  const KmFilm both = km_stack(half, half);
  expect_relative(both.R, .300530188184084);
  expect_relative(both.T, .381831043043140);
  expect_relative(km_film({.4, .7}, 1).R, both.R);
}

TEST(KubelkaMunkFilm, OverAGroundMeetsThePublishedExample) {
  const double K[] = {.2, .1, .22}, S[] = {.124, .658, .123}, ground[] = {.65, .2, .2146};
  const double expected[] = {.541596, .343822, .206651};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(km_over(km_film({K[i], S[i]}, .5), ground[i]), expected[i], 5e-7);  // six digits
  }
  EXPECT_NEAR(km_over(km_film({.2, 0}, .5), .65), .532175, 5e-7);
}

TEST(KubelkaMunkOpaque, IsTheLimitOfThickFilmsAndInvertsThePsiFunction) {
  for (const double q : {1e-6, 0.01, 0.5, 3.0, 1e4}) {
    const double R = km_opaque({q, 1});
    expect_relative((1 - R) * (1 - R) / (2 * R), q, 1e-9);  // 1 - R cancels at small q
    EXPECT_NEAR(km_film({q, 1}, 1e5).R, R, 1e-12);
  }
  EXPECT_EQ(km_opaque({1, 0}), 0);
}

TEST(Saunderson, MeetsReferenceValues) {
  EXPECT_NEAR(saunderson_seen(.5, .037461, .6), .312472, 5e-7);  // six digits
  EXPECT_EQ(saunderson_seen(0, .04, .6), .04);
  expect_relative(saunderson_seen(1, .04, .6), 1);
  for (const double R : {.02, .4, .97}) {
    expect_relative(saunderson_inside(saunderson_seen(R, .0375, .584), .0375, .584), R);
  }
}

std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

/// Amount-weighted mean (Duncan) of one band over the components.
double mix(const nlohmann::json& components, const std::vector<double>& share, std::size_t band) {
  double sum = 0;
  for (std::size_t i = 0; i < share.size(); ++i) sum += share[i] * numbers(components[i])[band];
  return sum;
}

/// 135 values of Unicolour's tests (tests/data/pigments/SOURCE.md). 1e-14: printed to 15 digits.
TEST(KubelkaMunkMixing, MeetsPublishedVectors) {
  std::ifstream file(PENTIMENTO_TEST_DATA "/pigments/km_mixing_vectors.json");
  const nlohmann::json all = nlohmann::json::parse(file);
  int checked = 0;
  for (const auto& [kind, set] : all.items()) {
    for (const nlohmann::json& c : set["cases"]) {
      const std::vector<double> share = numbers(c["conc"]), expected = numbers(c["R"]);
      for (std::size_t band = 0; band < expected.size(); ++band, ++checked) {
        double K = 0, S = 1;
        if (kind == "single_constant") {
          for (std::size_t i = 0; i < share.size(); ++i) {
            const double R = numbers(set["R"][i])[band];
            K += share[i] * (1 - R) * (1 - R) / (2 * R);
          }
        } else {
          K = mix(set["K"], share, band);
          S = mix(set["S"], share, band);
        }
        double R = km_opaque({K, S});
        // These vectors use Saunderson's correction without the leading k1.
        if (set.contains("k1")) R = saunderson_seen(R, set["k1"], set["k2"]) - double(set["k1"]);
        EXPECT_NEAR(R, expected[band], 1e-14) << kind;
      }
    }
  }
  EXPECT_EQ(checked, 135);
}

TEST(PigmentFromColor, LooksLikeTheColourOverWhiteAndDarkerOverBlack) {
  const Pigment p = pigment_from_color("x", {.5f, .02f, .9f}, .6f);
  const double color[] = {.5, .02, .9};
  for (int i = 0; i < 3; ++i) {
    const KmFilm film = km_film({p.K(i), p.S(i)}, 1);
    EXPECT_NEAR(km_over(film, 1), color[i], 1e-7);  // colours come in float
    EXPECT_NEAR(film.R, .6 * color[i], 1e-7);
  }
}

TEST(PigmentFromColor, AcceptsEveryColourOfTheCube) {
  for (const float c : {-1.0f, 0.0f, 1e-6f, 0.5f, 1.0f, 2.0f}) {
    for (const float opacity : {0.001f, 0.5f, 0.999f}) {
      const Pigment p = pigment_from_color("x", {c, c, c}, opacity);
      EXPECT_TRUE(std::isfinite(p.K(0)) && p.K(0) >= 0);
      EXPECT_TRUE(std::isfinite(p.S(0)) && p.S(0) >= 0);
    }
  }
}

}  // namespace
}  // namespace pentimento
