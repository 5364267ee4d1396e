#include "core/optics/gloss_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/optics/irradiance.h"
#include "core/optics/lighting.h"
#include "tests/reference/gloss.h"

namespace pentimento {
namespace {

constexpr float kIndex = 1.48f;
constexpr int kSide = GlossTable::kSide, kLevels = GlossTable::kLevels;

Panorama views(const LightProbe& p) {
  return {p[0].view(), p[1].view(), p[2].view()};
}

LightProbe gloss_panorama(int width, int height, auto&& radiance) {
  LightProbe rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = Field<float>(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto d = panorama_direction((x + 0.5) / width, (y + 0.5) / height);
        rgb[c](x, y) = static_cast<float>(radiance(d, c));
      }
    }
  }
  return rgb;
}

/// A room, brighter above, with a window that has sharp edges and a small lamp behind the viewer.
LightProbe room(int width, int height) {
  return gloss_panorama(width, height, [](const std::array<double, 3>& d, std::size_t c) {
    const bool window =
        d[2] > 0 && std::abs(d[0] / d[2] + 0.6) < 0.35 && d[1] / d[2] > 0.2 && d[1] / d[2] < 0.9;
    const double lamp = std::exp(-200 * (1 - (0.48 * d[0] - 0.36 * d[1] + 0.8 * d[2])));
    return 0.2 + 0.1 * d[1] + (window ? 6.0 + static_cast<double>(c) : 0) + 20 * lamp;
  });
}

GlossTable table_of(const LightProbe& probe, float roughness, int threads = 2) {
  return make_gloss_table(views(probe), {roughness, roughness, kIndex}, Threads(threads));
}

std::array<double, 3> normal_of(int i, int j) {
  const double x = (2 * i + 1.0) / kSide - 1, y = (2 * j + 1.0) / kSide - 1;
  return {x, y, std::sqrt(1 - x * x - y * y)};
}
const float* texel(const GlossTable& table, int level, int i, int j) {
  return table.rgb.data() + 3 * ((level * kSide + j) * kSide + i);
}

class GlossOfRoughness : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Roughness, GlossOfRoughness, testing::Values(0.45, 0.3, 0.16, 0.09));

TEST_P(GlossOfRoughness, IsTheMeanOfTheProbeOverTheLobe) {
  const double a = GetParam();
  const LightProbe probe = room(128, 64);
  const GlossTable table = table_of(probe, static_cast<float>(a));
  double largest = 0;
  for (int j = 6; j < kSide - 6; j += 8) {
    for (int i = 7; i < kSide - 6; i += 8) {
      const auto n = normal_of(i, j);
      if (!(n[2] > 0.3)) continue;
      const reference::Rgb truth = reference::mean_over_lobe(probe, n, a, kIndex);
      for (std::size_t c = 0; c < 3; ++c) {
        const double found = static_cast<double>(texel(table, 3, i, j)[c]);
        largest = std::max(largest, std::abs(found - truth[c]) / (1 + truth[c]));
      }
    }
  }
  // Down to 0.16 of roughness every pixel counts for itself: rounding of single precision. Rougher
  // surfaces take the probe's half, whose pixels are at most 0.4 a wide: a lobe of width 2 a
  // changes by (0.4 a)^2 / 24 times its second derivative, 1 / a^2, within one: 0.7 %.
  EXPECT_LT(largest, a > 0.2 ? 0.007 : 2e-6) << a;
}

TEST_P(GlossOfRoughness, OfAWhiteRoomIsWhiteLikeThatOfItsHarmonics) {
  const GlossTable table = table_of(gloss_panorama(64, 32, [](auto, auto) { return 1; }),
                                    static_cast<float>(GetParam()));
  for (int j = 0; j < kSide; j += 3) {
    for (int i = 0; i < kSide; i += 3) {
      const double x = (2 * i + 1.0) / kSide - 1, y = (2 * j + 1.0) / kSide - 1;
      // A mean of ones: rounding of a few hundred sums.
      if (x * x + y * y >= 1) continue;
      EXPECT_NEAR(texel(table, 0, i, j)[1], 1, 3e-6f);
    }
  }
}

TEST(GlossTable, AWindowIsSeenInItsPlaceInAMirror) {
  // One bright pixel at the upper left before the canvas, seen by the normal half way to the
  // viewer.
  LightProbe probe = gloss_panorama(128, 64, [](auto, auto) { return 0; });
  for (Field<float>& plane : probe) plane(50, 22) = 1;
  const auto d = panorama_direction(50.5 / 128, 22.5 / 64);
  const double size = std::sqrt(d[0] * d[0] + d[1] * d[1] + (1 + d[2]) * (1 + d[2]));
  const double n_x = d[0] / size, n_y = d[1] / size;
  const GlossTable table = table_of(probe, 0.001f);
  const int i = static_cast<int>((n_x + 1) / 2 * kSide),
            j = static_cast<int>((n_y + 1) / 2 * kSide);
  EXPECT_GT(texel(table, 0, i, j)[1], 0.1f);
  int bright = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (!(texel(table, 0, x, y)[1] > 0)) continue;
      ++bright;
      // A pixel to either side, 2.8 degrees, is half as much of the normal's angle: one texel.
      EXPECT_LE(std::abs(x - i), 1);
      EXPECT_LE(std::abs(y - j), 1);
    }
  }
  EXPECT_GT(bright, 0);
  EXPECT_LT(bright, 9);
}

TEST(GlossTable, LevelsGoFromDryToWet) {
  const LightProbe probe = room(64, 32);
  const GlossTable table = make_gloss_table(views(probe), {0.4f, 0.2f, kIndex}, Threads(1));
  const GlossTable dry = table_of(probe, 0.4f), wet = table_of(probe, 0.2f);
  for (int j = 20; j < 45; j += 3) {
    EXPECT_EQ(texel(table, 0, 30, j)[0], texel(dry, 0, 30, j)[0]);
    EXPECT_EQ(texel(table, kLevels - 1, 30, j)[0], texel(wet, 0, 30, j)[0]);
  }
}

TEST(GlossTable, IsTheSameForAnyThreads) {
  const LightProbe probe = room(64, 32);
  const std::vector<float> one = table_of(probe, 0.3f, 1).rgb;
  EXPECT_EQ(one, table_of(probe, 0.3f, 3).rgb);
  EXPECT_EQ(one, make_gloss_table(views(probe), {0.3f, 0.3f, kIndex}, Threads::backwards()).rgb);
}

TEST(GlossTable, TakesPanoramasOfAnySize) {
  for (const auto& [w, h] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{30, 50}}) {
    const GlossTable table = table_of(gloss_panorama(w, h, [](auto, auto) { return 2; }), 0.3f);
    EXPECT_NEAR(texel(table, 7, 32, 32)[2], 2, 1e-5f);
  }
}

}  // namespace
}  // namespace pentimento
