// Light probes from files of each kind, as nine coefficients against all of their light.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/optics/gloss_table.h"
#include "core/optics/irradiance.h"
#include "formats/image/read_image.h"
#include "formats/image/resample.h"
#include "tests/reference/gloss.h"

namespace pentimento {
namespace {

using Planes = std::array<Field<float>, 3>;
constexpr double kPi = 3.14159265358979323846;

/// Reduced to 128 x 64, so that every pixel can light every normal.
Planes probe(const std::string& name) {
  auto rgb = read_rgb(std::string(PENTIMENTO_SOURCE_DIR) + "/tests/data/probes/" + name);
  EXPECT_TRUE(rgb) << rgb.error().message;
  Planes small;
  for (std::size_t c = 0; rgb && c < 3; ++c) {
    small[c] = resample_area((*rgb)[c].view(), 128, 64);
  }
  return small;
}

/// By its definition: the sum over all pixels of L max(n.d, 0) times the pixel's solid angle.
double brute_force(const Field<float>& L, const std::array<double, 3>& n) {
  double sum = 0;
  for (int y = 0; y < L.height(); ++y) {
    const double area = 2 * kPi / L.width() *
                        (std::cos(kPi * y / L.height()) - std::cos(kPi * (y + 1) / L.height()));
    for (int x = 0; x < L.width(); ++x) {
      const auto d = panorama_direction((x + 0.5) / L.width(), (y + 0.5) / L.height());
      const double cosine = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
      sum += static_cast<double>(L(x, y)) * std::max(cosine, 0.0) * area;
    }
  }
  return sum;
}

/// Over normals spread evenly over the sphere (Fibonacci's spiral), of the green light.
struct IrradianceError {
  double of_mean = 0;     // mean of |E_9 - E| over the mean of E
  double of_largest = 0;  // and over the largest E
  double largest = 0;     // largest |E_9 - E| over the largest E
};

IrradianceError irradiance_error(const Planes& rgb) {
  const ShCoefficients nine = project_panorama({rgb[0].view(), rgb[1].view(), rgb[2].view()});
  constexpr int kNormals = 200;
  double error = 0, total = 0, most = 0, worst = 0;
  for (int i = 0; i < kNormals; ++i) {
    const double z = 1 - (2 * i + 1.0) / kNormals, turn = i * kPi * (3 - std::sqrt(5.0));
    const double level = std::sqrt(1 - z * z);
    const std::array<double, 3> n = {level * std::cos(turn), level * std::sin(turn), z};
    const double exact = brute_force(rgb[1], n);
    const auto E = sh_irradiance(
        nine, {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    const double off = std::abs(static_cast<double>(E[1]) - exact);
    error += off;
    total += exact;
    most = std::max(most, exact);
    worst = std::max(worst, off);
  }
  return {error / total, error / (kNormals * most), worst / most};
}
double mean_error(const Planes& rgb) {
  return irradiance_error(rgb).of_mean;
}

/// The part of max(c, 0) that nine harmonics hold, as a function of the angle's cosine c:
/// Legendre's polynomials of order 0, 1, 2 with the weights of Ramamoorthi and Hanrahan 2001, eq. 7
/// and 8.
double nine_term_cosine(double c) {
  return 1.0 / 4 + c / 2 + 5.0 / 32 * (3 * c * c - 1);
}

/// Mean over all directions of |what is made of the nine terms - max(c, 0)|, over the mean of
/// max(c, 0), which is 1/4.
double mean_error_of_cosine(auto&& made_of) {
  constexpr int kSlices = 100000;
  double sum = 0;
  for (int i = 0; i < kSlices; ++i) {
    const double c = -1 + (2 * i + 1.0) / kSlices;
    sum += std::abs(made_of(nine_term_cosine(c)) - std::max(c, 0.0)) / kSlices;
  }
  return 4 * sum;
}

/// By the triangle inequality no light that is nowhere negative has a larger mean error; cutting
/// values below 0 brings each nearer to the truth.
double largest_mean_error() {
  return mean_error_of_cosine([](double E) { return E; });
}

class LightProbe : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Files, LightProbe,
                         testing::Values("sunset.exr", "forest.exr", "studio.hdr", "city.exr",
                                         "studio.exr"));

// Our own error: none but rounding. The other path has no harmonics in it: every pixel through the
// truncated cosine (the addition theorem).
TEST_P(LightProbe, NineCoefficientsAreTheLowOrdersOfItsIrradiance) {
  const Planes rgb = probe(GetParam());
  const Field<float>& L = rgb[1];
  const ShCoefficients nine = project_panorama({rgb[0].view(), rgb[1].view(), rgb[2].view()});
  for (int i = 0; i < 20; ++i) {
    const double z = 1 - (2 * i + 1.0) / 20, level = std::sqrt(1 - z * z);
    const std::array<double, 3> n = {level * std::cos(2.4 * i), level * std::sin(2.4 * i), z};
    double truth = 0, all = 0;
    for (int y = 0; y < L.height(); ++y) {
      const double area = 2 * kPi / L.width() *
                          (std::cos(kPi * y / L.height()) - std::cos(kPi * (y + 1) / L.height()));
      for (int x = 0; x < L.width(); ++x) {
        const auto d = panorama_direction((x + 0.5) / L.width(), (y + 0.5) / L.height());
        const double light = static_cast<double>(L(x, y)) * area;
        truth += light * nine_term_cosine(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
        all += light;
      }
    }
    const auto E = sh_irradiance(
        nine, {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    // Nine coefficients and a normal rounded to single precision, none of them above all the light.
    EXPECT_NEAR(static_cast<double>(E[1]), std::max(truth, 0.0), 16 * 6e-8 * all);
  }
}

// The method's error: what nine harmonics cannot hold.
TEST_P(LightProbe, NineCoefficientsMissNoMoreThanAnyLightCan) {
  EXPECT_LT(mean_error(probe(GetParam())), largest_mean_error());
}

// What its gloss shows, against every pixel through the lobe.
TEST_P(LightProbe, GlossIsTheMeanOverTheLobe) {
  const Planes rgb = probe(GetParam());
  for (const float a : {0.45f, 0.16f}) {
    const GlossTable table =
        make_gloss_table({rgb[0].view(), rgb[1].view(), rgb[2].view()}, {a, a, 1.48f}, Threads(2));
    double error = 0, total = 0;
    for (int j = 10; j < GlossTable::kSide; j += 11) {
      for (int i = 10; i < GlossTable::kSide; i += 11) {
        const double x = (2 * i + 1.0) / GlossTable::kSide - 1;
        const double y = (2 * j + 1.0) / GlossTable::kSide - 1;
        if (x * x + y * y > 0.9) continue;
        const auto truth =
            reference::mean_over_lobe(rgb, {x, y, std::sqrt(1 - x * x - y * y)},
                                      static_cast<double>(a), static_cast<double>(1.48f));
        const float found =
            table.rgb[static_cast<std::size_t>(3 * (j * GlossTable::kSide + i) + 1)];
        error += std::abs(static_cast<double>(found) - truth[1]);
        total += truth[1];
      }
    }
    EXPECT_LT(error / total, a > 0.3f ? 0.007 : 2e-6) << a;  // as in gloss_table_test.cpp
  }
}

TEST(LightProbeTruncation, OfOnePointOfLightIsThatOfTheCosine) {
  Planes point;
  for (Field<float>& plane : point) plane = Field<float>(128, 64);
  for (Field<float>& plane : point) plane(40, 30) = 1000;
  const double expected = mean_error_of_cosine([](double E) { return std::max(E, 0.0); });
  // Two hundred normals stand for all: 0.07 = 1 / sqrt(200) is how far apart they are.
  // c.
  EXPECT_NEAR(mean_error(point), expected, 0.07 * expected);
  EXPECT_LT(expected, largest_mean_error());
}

/// The table of docs/light.md.
TEST(LightProbeTruncation, DISABLED_TableOfErrors) {
  for (const char* name : {"sunset.exr", "forest.exr", "studio.hdr", "city.exr", "studio.exr"}) {
    const IrradianceError error = irradiance_error(probe(name));
    std::printf("| %s | %.2f %% | %.2f %% | %.2f %% |\n", name, 100 * error.of_mean,
                100 * error.of_largest, 100 * error.largest);
  }
}

TEST(LightProbeTruncation, OfASunsetIsBelowThePublishedPerCent) {
  // "average errors of only 1%", Ramamoorthi and Hanrahan 2001: light from wide areas.
  EXPECT_LT(mean_error(probe("sunset.exr")), 0.01);
}

}  // namespace
}  // namespace pentimento
