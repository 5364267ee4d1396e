#include "core/debug/color_map.h"

#include <gtest/gtest.h>

#include "core/optics/srgb.h"

namespace pentimento {
namespace {

Code8 code_of(const Linear3& light) {
  Code8 code{};
  for (std::size_t c = 0; c < 3; ++c)
    code[c] = static_cast<std::uint8_t>(linear_to_srgb(static_cast<double>(light[c])) * 255 + 0.5);
  return code;
}

TEST(ColorMap, MeetsThePublishedColoursAtItsNodes) {
  EXPECT_EQ(code_of(color_at(viridis(), 0)), (Code8{0x44, 0x01, 0x54}));
  EXPECT_EQ(code_of(color_at(viridis(), 1)), (Code8{0xfd, 0xe7, 0x25}));
  EXPECT_EQ(code_of(color_at(viridis(), 3.0 / 9)), (Code8{0x31, 0x68, 0x8e}));
  EXPECT_EQ(code_of(color_at(blues(), 0.5)), (Code8{0x6b, 0xae, 0xd6}));
  // Half way between two nodes: the mean of their codes, rounded up.
  EXPECT_EQ(code_of(color_at(blues(), 0.125)), (Code8{0xd6, 0xe5, 0xf3}));
  EXPECT_EQ(code_of(color_at(magma(), -3)), code_of(color_at(magma(), 0)));
  EXPECT_EQ(code_of(color_at(magma(), 7)), code_of(color_at(magma(), 1)));
}

TEST(ColorMap, GrowsBrighterAlongViridisAndMagma) {
  const auto luminance = [](const Linear3& c) {
    return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
  };
  for (const ColorNodes nodes : {viridis(), magma()}) {
    for (int i = 0; i < 100; ++i)
      EXPECT_LT(luminance(color_at(nodes, i / 100.0)), luminance(color_at(nodes, (i + 1) / 100.0)));
  }
}

TEST(ColorMap, TheCircleOfHuesIsRedGreenBlue) {
  const Code8 ground = {24, 24, 24};
  EXPECT_EQ(code_of(hue_over(ground, 0, 1)), (Code8{255, 0, 0}));
  EXPECT_EQ(code_of(hue_over(ground, 1.0 / 3, 1)), (Code8{0, 255, 0}));
  EXPECT_EQ(code_of(hue_over(ground, -1.0 / 3, 1)), (Code8{0, 0, 255}));
  EXPECT_EQ(code_of(hue_over(ground, 0.25, 0)), ground);
}

}  // namespace
}  // namespace pentimento
