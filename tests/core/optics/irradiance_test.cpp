#include "core/optics/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pentimento {
namespace {

// Ramamoorthi and Hanrahan's light probes, as published with their programs.
constexpr ShCoefficients kGrace{{{{.78908f, .43710f, .54161f},
                                  {.39499f, .34989f, .60488f},
                                  {-.33974f, -.18236f, -.26940f},
                                  {-.29213f, -.05562f, .00944f},
                                  {-.11141f, -.05090f, -.12231f},
                                  {-.26240f, -.22401f, -.47479f},
                                  {-.15570f, -.09471f, -.14733f},
                                  {.56014f, .21444f, .13915f},
                                  {.21205f, -.05432f, -.30374f}}}};
constexpr ShCoefficients kEucalyptus{{{{.3783264f, .4260425f, .4504587f},
                                       {.2887813f, .3586803f, .4147053f},
                                       {.0379030f, .0295216f, .0098567f},
                                       {-.1033028f, -.1031690f, -.0884924f},
                                       {-.0621750f, -.0554432f, -.0396779f},
                                       {.0077820f, -.0148312f, -.0471301f},
                                       {-.0935561f, -.1254260f, -.1525629f},
                                       {-.0572703f, -.0502192f, -.0363410f},
                                       {.0203348f, -.0044201f, -.0452180f}}}};
constexpr ShCoefficients kStPeters{{{{.3623915f, .2624130f, .2326261f},
                                     {.1759130f, .1436267f, .1260569f},
                                     {-.0247311f, -.0101253f, -.0010745f},
                                     {.0346500f, .0223184f, .0101350f},
                                     {.0198140f, .0144073f, .0043987f},
                                     {-.0469596f, -.0254485f, -.0117786f},
                                     {-.0898667f, -.0760911f, -.0740964f},
                                     {.0050194f, .0038841f, .0001374f},
                                     {-.0818750f, -.0321501f, .0033399f}}}};

void expect_rgb(std::array<float, 3> value, std::array<float, 3> expected, float tolerance) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << c;
}

TEST(ShIrradiance, MeetsThePublishedProbes) {
  constexpr float kSixDigits = 1.1e-6f;  // as given, plus float coefficients
  expect_rgb(sh_irradiance(kGrace, {0, 0, 1}), {.274503f, .153835f, .131316f}, kSixDigits);
  expect_rgb(sh_irradiance(kEucalyptus, {0, 0, 1}), {.327721f, .345643f, .333713f}, kSixDigits);
  expect_rgb(sh_irradiance(kStPeters, {0, 0, 1}), {.251332f, .184499f, .168351f}, kSixDigits);
  expect_rgb(sh_irradiance(kGrace, {0, 1, 0}), {1.051097f, .792188f, 1.265791f}, kSixDigits);
  expect_rgb(sh_irradiance(kEucalyptus, {0, 1, 0}), {.645251f, .777583f, .880779f}, kSixDigits);
  expect_rgb(sh_irradiance(kStPeters, {0, 1, 0}), {.558566f, .412177f, .352078f}, kSixDigits);
}

ShCoefficients from_basis(const std::array<double, 9>& Y) {
  ShCoefficients light;
  for (std::size_t i = 0; i < 9; ++i) light.L[i].fill(static_cast<float>(Y[i]));
  return light;
}

TEST(ShIrradiance, OfADirectionalLightMeetsReferenceValuesAndIsNeverNegative) {
  const ShCoefficients light = from_basis(sh_basis({0, 0, 1}));
  const double cases[][2] = {{0, 1.0625},  {30, .878325}, {60, .4609375},
                             {90, .09375}, {120, 0},      {180, .0625}};  // 120: -.039 unclamped
  for (const auto& [degrees, expected] : cases) {
    const double angle = degrees * static_cast<double>(std::numbers::pi_v<float>) / 180;
    const auto E = sh_irradiance(
        light, {0, static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))});
    EXPECT_NEAR(E[0], expected, 1e-6) << degrees;  // six digits
  }
}

TEST(ShIrradiance, OfUniformRadianceIsPi) {
  ShCoefficients light;
  light.L[0] = {3.5449077f, 3.5449077f, 3.5449077f};
  expect_rgb(sh_irradiance(light, {.6f, 0, .8f}),
             {std::numbers::pi_v<float>, std::numbers::pi_v<float>, std::numbers::pi_v<float>},
             1e-6f);
}

TEST(ShIrradiance, OfAHemisphereOfLightIsPiOnItsAxis) {
  ShCoefficients light;
  light.L[0].fill(1.7724539f);
  light.L[2].fill(1.5349901f);
  expect_rgb(sh_irradiance(light, {0, 0, 1}),
             {std::numbers::pi_v<float>, std::numbers::pi_v<float>, std::numbers::pi_v<float>},
             1e-6f);
}

std::array<Field<float>, 3> panorama(int width, int height, auto&& radiance) {
  std::array<Field<float>, 3> rgb;
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
ShCoefficients project(const std::array<Field<float>, 3>& p) {
  return project_panorama({p[0].view(), p[1].view(), p[2].view()});
}

TEST(Panorama, IsSeenFromTheCanvas) {
  const auto expect_direction = [](double u, double v, std::array<double, 3> d) {
    const auto found = panorama_direction(u, v);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], d[i], 1e-15);
  };
  expect_direction(0.5, 0.5, {0, 0, 1});
  expect_direction(0.5, 0, {0, 1, 0});
  expect_direction(0.75, 0.5, {-1, 0, 0});
  expect_direction(0.25, 0.5, {1, 0, 0});
}

TEST(PanoramaProjection, OfUniformRadianceIsExactAtAnySize) {
  for (const auto& [w, h] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{64, 32}}) {
    const ShCoefficients light = project(panorama(w, h, [](auto, auto) { return 1; }));
    EXPECT_NEAR(light.L[0][1], 3.5449077f, 1e-6f);
  }
}

TEST(PanoramaProjection, RecoversTheHarmonicsItIsMadeOf) {
  const std::array<double, 9> truth = {1, .2, -.3, .15, .1, -.05, .2, .12, -.08};
  const auto probe = panorama(128, 64, [&](auto d, auto) {
    const auto Y = sh_basis(d);
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i) sum += truth[i] * Y[i];
    return sum;
  });
  const ShCoefficients light = project(probe);
  // Midpoint rule in pixels of 2.8 degrees: 1 - cos of half a pixel, about 3e-4 per coefficient.
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(light.L[i][0], truth[i], 1e-3) << i;
}

/// Irradiance by summing radiance times cosine over every pixel.
double brute_force(const Field<float>& plane, std::array<double, 3> n) {
  const int w = plane.width(), h = plane.height();
  double sum = 0;
  for (int y = 0; y < h; ++y) {
    const double area = 2 * static_cast<double>(std::numbers::pi_v<float>) / w *
                        (std::cos(static_cast<double>(std::numbers::pi_v<float>) * y / h) -
                         std::cos(static_cast<double>(std::numbers::pi_v<float>) * (y + 1) / h));
    for (int x = 0; x < w; ++x) {
      const auto d = panorama_direction((x + 0.5) / w, (y + 0.5) / h);
      const double cosine = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
      sum += std::max(cosine, 0.0) * static_cast<double>(plane(x, y)) * area;
    }
  }
  return sum;
}

TEST(ShIrradiance, IsWithinAPerCentOfBruteForceOnAStudioProbe) {
  // A room with a large soft window at the upper left. RH01: "average errors of only 1%".
  const auto probe = panorama(64, 32, [](auto d, auto) {
    const double window = -.5 * d[0] + .6 * d[1] + .62 * d[2];
    return 0.4 + 0.2 * d[1] + 3 * std::pow(std::max(window, 0.0), 6);
  });
  const ShCoefficients light = project(probe);
  double error = 0, total = 0;
  for (int i = 0; i < 60; ++i) {  // normals over the hemisphere that a canvas shows
    const double z = 0.3 + 0.7 * i / 59, r = std::sqrt(1 - z * z), turn = 2.4 * i;
    const std::array<double, 3> n = {r * std::cos(turn), r * std::sin(turn), z};
    const double exact = brute_force(probe[0], n);
    const auto E = sh_irradiance(
        light, {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    error += std::abs(static_cast<double>(E[0]) - exact);
    total += exact;
  }
  EXPECT_LT(error / total, 0.01);
}

TEST(StudioEnvironment, IsNeutralBrightestFromTheUpperLeftAndNowhereNegative) {
  const ShCoefficients& light = kStudioEnvironment;
  const auto E = [&](std::array<float, 3> n) { return sh_irradiance(light, n)[1]; };
  EXPECT_GT(E({-.3f, .4f, .866f}), E({.3f, .4f, .866f}));
  EXPECT_GT(E({-.3f, .4f, .866f}), E({-.3f, -.4f, .866f}));
  for (int i = 0; i < 200; ++i) {
    const float z = 1 - static_cast<float>(i) / 100, r = std::sqrt(std::max(1 - z * z, 0.0f));
    const float turn = 2.4f * static_cast<float>(i);
    EXPECT_GT(sh_radiance(light, {r * std::cos(turn), r * std::sin(turn), z})[0], 0);
  }
}

}  // namespace
}  // namespace pentimento
