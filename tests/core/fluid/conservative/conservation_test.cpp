#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

float noise(int x, int y, unsigned seed) {
  unsigned h = static_cast<unsigned>(x) * 374761393u + static_cast<unsigned>(y) * 668265263u + seed;
  h = (h ^ (h >> 13)) * 1274126177u;
  return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 65536.0f;
}

// Two layers of two pigments of uneven stiffness on an uneven, partly bare canvas, tilted.
Basin painted(int width, int height, int threads) {
  Basin b({width, height, width / 1024.0, height / 1024.0}, 2, 2, threads);
  b.gravity_m_s2 = {3, -5, 7};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      b.state.base_m(x, y) = 3e-4f * noise(x, y, 1);
      const bool bare = noise(x / 9, y / 9, 2) < 0.4f;
      const float d = bare ? 0.0f : 0.008f * noise(x / 5, y / 5, 3);
      b.state.depth_m(x, y) = d;
      for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 2; ++c)
          b.state.channel(k, c)(x, y) =
              d * 6 * noise(x / 4, y / 4, static_cast<unsigned>(4 + 2 * k + c));
    }
  return b;
}

TEST(ConservativeScheme, KeepsEveryPaintAndNothingIsNegative) {
  Basin b = painted(96, 64, 1);
  b.step();  // settles to whole quanta: half a quantum per plane may be lost here
  const double depth = total(b.state.depth_m);
  std::vector<double> pigment;
  for (const auto& plane : b.state.pigment) pigment.push_back(total(plane));
  b.steps(60);
  EXPECT_GT(b.statistic("max_speed_m_s"), 0.02);
  // Whole quanta below 2^24 of them: exact, not just close.
  EXPECT_EQ(total(b.state.depth_m), depth);
  EXPECT_GE(lowest(b.state.depth_m), 0.0f);
  for (std::size_t k = 0; k < pigment.size(); ++k) {
    EXPECT_EQ(total(b.state.pigment[k]), pigment[k]) << k;
    EXPECT_GE(lowest(b.state.pigment[k]), 0.0f) << k;
  }
}

TEST(ConservativeScheme, GivesTheSameBitsForAnyThreadCount) {
  Basin one = painted(150, 90, 1);
  one.steps(20);
  for (const int threads : {2, 7}) {
    Basin many = painted(150, 90, threads);
    many.steps(20);
    EXPECT_TRUE(same_bits(one.state.depth_m, many.state.depth_m)) << threads;
    EXPECT_TRUE(same_bits(one.state.velocity_x_m_s, many.state.velocity_x_m_s)) << threads;
    EXPECT_TRUE(same_bits(one.state.velocity_y_m_s, many.state.velocity_y_m_s)) << threads;
    for (std::size_t k = 0; k < one.state.pigment.size(); ++k)
      EXPECT_TRUE(same_bits(one.state.pigment[k], many.state.pigment[k])) << threads;
  }
}

// FNV-1a over the bits of what moves.
std::uint64_t hash_of(const CanvasState& state) {
  std::uint64_t hash = 1469598103934665603u;
  const auto mix = [&](const Field<float>& plane) {
    for (int y = 0; y < plane.height(); ++y)
      for (int x = 0; x < plane.width(); ++x)
        hash = (hash ^ std::bit_cast<std::uint32_t>(plane(x, y))) * 1099511628211u;
  };
  mix(state.depth_m);
  mix(state.velocity_x_m_s);
  mix(state.velocity_y_m_s);
  for (const Field<float>& plane : state.pigment) mix(plane);
  return hash;
}

TEST(ConservativeScheme, GivesTheSameBitsOnEveryBuild) {
  // Found alike with g++ -O0, g++ -O3 (kernels for AVX-512), g++ for AVX2, clang -O2 and clang
  // -march=native. Changes with the scheme, never with the machine.
  Basin b = painted(150, 90, 1);
  b.contact.push_x_m(50, 50) = 0.003f;
  b.contact.weight(50, 50) = 1;
  b.contact.touch(50, 51, 50, 51);
  b.steps(30);
  EXPECT_EQ(hash_of(b.state), 0x1a590e65ccd6e1d5u) << std::hex << hash_of(b.state);
}

}  // namespace
}  // namespace pentimento::conservative
