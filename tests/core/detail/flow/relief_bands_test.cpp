#include "core/detail/flow/relief_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pentimento {
namespace {

constexpr double kPi = 3.14159265358979;

Field<float> plane(int width, int height, const std::function<double(int, int)>& value) {
  Field<float> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out(x, y) = static_cast<float>(value(x, y));
  return out;
}

TEST(StandingAmplitude, IsTheYieldStressOverThePressureOfTheCurvature) {
  // By hand: 100 Pa / (0.032 N/m (2 pi / 1 mm)^2) = 79 micrometres on a deep film.
  const ReliefStrength strength{100 / 0.032f, 1e-4f};
  EXPECT_NEAR(standing_amplitude_m(strength, 1e-3f, 1.0f), 7.92e-5, 2e-7);
  // Half the wavelength holds a quarter.
  EXPECT_NEAR(standing_amplitude_m(strength, 5e-4f, 1.0f), 1.98e-5, 1e-7);
}

TEST(StandingAmplitude, IsLargerOnAFilmThatIsThinAgainstTheWavelength) {
  const ReliefStrength strength{100 / 0.032f, 1e-4f};
  // 1 / q of a millimetre is 0.159 mm: a film of a tenth of that holds ten times as much.
  EXPECT_NEAR(standing_amplitude_m(strength, 1e-3f, 1.59155e-5f), 7.92e-4, 2e-6);
  EXPECT_EQ(standing_amplitude_m(strength, 1e-3f, 1.6e-4f),
            standing_amplitude_m(strength, 1e-3f, 1.0f));
  // A dry cell is as the thinnest film, not endless.
  EXPECT_LT(standing_amplitude_m(strength, 1e-3f, 0), 0.02f);
}

TEST(TriangleMean, IsTheTrianglesSumAtEveryWidthAndSymmetric) {
  for (const int width : {1, 2, 3, 4, 5, 8}) {
    const Field<float> spike =
        plane(41, 37, [](int x, int y) { return x == 20 && y == 18 ? 1.0 : 0.0; });
    Field<float> out(41, 37);
    triangle_mean(spike, width, out);
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 41; ++x) {
        const auto triangle = [&](int from) {
          return std::max(0.0, (width - std::abs(from)) / static_cast<double>(width * width));
        };
        // Doubles rounded to float twice.
        EXPECT_NEAR(out(x, y), triangle(x - 20) * triangle(y - 18), 1e-7) << width;
      }
    }
  }
}

TEST(TriangleMean, KeepsAConstantAndRepeatsTheOutermostCells) {
  const Field<float> ramp = plane(9, 3, [](int x, int) { return x < 4 ? 2.0 : 3.0; });
  Field<float> out(9, 3);
  triangle_mean(ramp, 4, out);
  for (int y = 0; y < 3; ++y) {
    EXPECT_FLOAT_EQ(out(0, y), 2.0f);
    EXPECT_FLOAT_EQ(out(8, y), 3.0f);
  }
}

/// Amplitude of a ripple after levelling, in the middle of a wide plane.
double left_of(double amplitude_m, double wavelength_cells, int factor, float cell_m,
               float film_m = 1.0f) {
  Field<float> relief = plane(
      256, 8, [&](int x, int) { return amplitude_m * std::sin(2 * kPi * x / wavelength_cells); });
  const Field<float> film(256, 8, film_m);
  level_bands({100 / 0.032f, cell_m}, factor, film, relief);
  double largest = 0;
  for (int x = 100; x < 156; ++x) largest = std::max(largest, std::abs(double{relief(x, 4)}));
  return largest;
}

TEST(LevelBands, LeavesWhatTheYieldStressHolds) {
  // A ripple of 1.5 guide cells of a millimetre and of a tenth of what stands: 1 % of it goes.
  const double stands =
      static_cast<double>(standing_amplitude_m({100 / 0.032f, 1.25e-4f}, 1.5e-3f, 1.0f));
  EXPECT_NEAR(left_of(0.1 * stands, 12, 8, 1.25e-4f), 0.1 * stands, 0.02 * 0.1 * stands);
}

TEST(LevelBands, FlattensWhatIsFarHigherToWhatStands) {
  // Ten times as high as what stands at its wavelength. Some 15 % of a ripple lies in the wider
  // band, which holds four times as much: so 1 + 1.5 times what stands is left, and a little.
  for (const double cells : {3.0, 6.0}) {
    const double stands = static_cast<double>(
        standing_amplitude_m({100 / 0.032f, 1.25e-4f}, static_cast<float>(cells) * 1.25e-4f, 1.0f));
    const double left = left_of(10 * stands, cells, 8, 1.25e-4f);
    EXPECT_LT(left, 3.2 * stands) << cells;
    EXPECT_GT(left, 0.4 * stands) << cells;
  }
}

TEST(LevelBands, LeavesWavesOfTheGuideAlone) {
  // Eight cells of the guide long and 5 mm high: the triangle's own loss, 5 %, is in the first
  // band.
  EXPECT_GT(left_of(5e-3, 64, 8, 1.25e-4f), 0.94 * 5e-3);
}

TEST(LevelBands, GivesTheSameRippleOnTwiceAsManyCells) {
  // 0.75 mm on cells of 1/4 and of 1/8 mm. The coarser grid has 3 cells a wave and sees less of it.
  const double coarse = left_of(1e-3, 3, 4, 2.5e-4f), fine = left_of(1e-3, 6, 8, 1.25e-4f);
  EXPECT_NEAR(coarse / fine, 1, 0.25);
}

TEST(LevelBands, LeavesAThinFilmAsItIs) {
  // 10 micrometres over threads of 0.1 mm: what a film so thin holds is far more.
  EXPECT_GT(left_of(1e-4, 12, 8, 1.25e-4f, 1e-5f), 0.95e-4);
}

TEST(LevelBands, DoesNothingToAFlatPlaneAndAtDetailOne) {
  Field<float> flat(20, 20, 0.25f);
  const Field<float> film(20, 20, 1e-3f);
  level_bands({3000, 1e-4f}, 8, film, flat);
  for (int x = 0; x < 20; ++x) EXPECT_NEAR(flat(x, 7), 0.25f, 1e-7f);
  Field<float> noise = plane(20, 20, [](int x, int y) { return (x * 7 + y * 3) % 5; });
  const Field<float> before = noise.clone();
  level_bands({3000, 1e-4f}, 1, film, noise);
  for (int x = 0; x < 20; ++x) EXPECT_FLOAT_EQ(noise(x, 7), before(x, 7));
}

}  // namespace
}  // namespace pentimento
