#include "core/debug/color_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/check.h"
#include "core/optics/srgb.h"

namespace pentimento {

namespace {
constexpr std::array<Code8, 10> kViridis = {{{0x44, 0x01, 0x54},
                                             {0x48, 0x28, 0x78},
                                             {0x3e, 0x4a, 0x89},
                                             {0x31, 0x68, 0x8e},
                                             {0x26, 0x82, 0x8e},
                                             {0x1f, 0x9e, 0x89},
                                             {0x35, 0xb7, 0x79},
                                             {0x6e, 0xce, 0x58},
                                             {0xb5, 0xde, 0x2b},
                                             {0xfd, 0xe7, 0x25}}};
constexpr std::array<Code8, 10> kMagma = {{{0x00, 0x00, 0x04},
                                           {0x18, 0x0f, 0x3d},
                                           {0x44, 0x0f, 0x76},
                                           {0x72, 0x1f, 0x81},
                                           {0x9e, 0x2f, 0x7f},
                                           {0xcd, 0x40, 0x71},
                                           {0xf1, 0x60, 0x5d},
                                           {0xfd, 0x96, 0x68},
                                           {0xfe, 0xca, 0x8d},
                                           {0xfc, 0xfd, 0xbf}}};
constexpr std::array<Code8, 5> kBlues = {{{0xef, 0xf3, 0xff},
                                          {0xbd, 0xd7, 0xe7},
                                          {0x6b, 0xae, 0xd6},
                                          {0x31, 0x82, 0xbd},
                                          {0x08, 0x51, 0x9c}}};

float linear(double code) {
  return static_cast<float>(srgb_to_linear(code / 255));
}
}  // namespace

Linear3 linear_of(const Code8& code) {
  return {linear(code[0]), linear(code[1]), linear(code[2])};
}

Linear3 color_at(ColorNodes nodes, double t) {
  PENTIMENTO_CHECK(nodes.size() >= 2);
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(nodes.size() - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(at), nodes.size() - 2);
  const double share = at - static_cast<double>(before);
  Linear3 out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double a = nodes[before][c], b = nodes[before + 1][c];
    out[c] = linear(a + (b - a) * share);
  }
  return out;
}

ColorNodes viridis() {
  return kViridis;
}
ColorNodes magma() {
  return kMagma;
}
ColorNodes blues() {
  return kBlues;
}

Linear3 hue_over(const Code8& ground, double turn, double share) {
  const double at = 6 * (turn - std::floor(turn));
  // Red, green and blue stand a third of the circle apart, each full over a third.
  const std::array<double, 3> hue = {std::abs(at - 3) - 1, 2 - std::abs(at - 2),
                                     2 - std::abs(at - 4)};
  const double part = std::clamp(share, 0.0, 1.0);
  Linear3 out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double full = 255 * std::clamp(hue[c], 0.0, 1.0);
    out[c] = linear(ground[c] + (full - ground[c]) * part);
  }
  return out;
}

}  // namespace pentimento
