#include "replay/log/palette.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/optics/kubelka_munk.h"
#include "core/optics/paints/paint_maker.h"
#include "core/optics/srgb.h"
#include "replay/play/channel_change.h"

namespace pentimento {
namespace {

TEST(Palette, APickedColourJoinsOnce) {
  Palette palette = Palette::make({}).value();
  const log::Color yellow{{}, log::Rgb{0.6, 0.5, 0.02}, {}};
  palette.pick(yellow);
  palette.pick(yellow);
  EXPECT_EQ(palette.pigments().size(), 2u);
  EXPECT_EQ(palette.find(yellow), 1);
}

TEST(Palette, EveryPickedCodeHasItsOwnName) {
  Palette palette = Palette::make({}).value();
  for (int code = 0; code < 256; ++code) {
    const double light = srgb_to_linear(code / 255.0);
    palette.pick({{}, log::Rgb{light, light, light}, {}});
    EXPECT_TRUE(palette.has(fmt::format("#{0:02x}{0:02x}{0:02x}", code))) << code;
  }
  // What lies between two codes has the name of the nearer one.
  Palette between = Palette::make({}).value();
  const double light = srgb_to_linear(127.8 / 255);
  between.pick({{}, log::Rgb{light, light, light}, {}});
  EXPECT_TRUE(between.has("#808080"));
}

TEST(Palette, AnEmptyOnePaintsBlack) {
  EXPECT_EQ(Palette::make({}).value().pigments().front().name, "Ivory Black");
}

TEST(Palette, ALibraryPigmentIsFoundByName) {
  log::PigmentSpec spec;
  spec.name = "Hansa Yellow";
  spec.library = true;
  const Pigment pigment = make_pigment(spec).value();
  EXPECT_DOUBLE_EQ(pigment.K(0), 0.06);  // Curtis et al. 1997, fig. 5
  EXPECT_DOUBLE_EQ(pigment.S(2), 0.009);
  spec.name = "unobtainium";
  EXPECT_EQ(make_pigment(spec).error().code, ErrorCode::kBadInput);
}

TEST(ChannelChange, PalettePlanesBecomeOpticalOnesOfTheSamePaint) {
  const std::vector<Pigment> first = {pigment_from_color("a", {0.1f, 0.2f, 0.3f}),
                                      pigment_from_color("b", {0.5f, 0.2f, 0.1f})};
  std::vector<Pigment> many = first;
  for (int i = 0; i < 9; ++i) {
    many.push_back(pigment_from_color(std::to_string(i), {0.1f, 0.1f, 0.1f}));
  }
  const std::vector<Pigment> joined = join_palettes(first, many).value();
  EXPECT_EQ(joined.size(), 11u);
  const ChannelBasis old = palette_channels(first);
  const ChannelBasis basis = channels_after(old, joined);
  CanvasState state = make_canvas_state({4, 3, 1, 1}, 2, 2, 3, 0.9f);
  state.channel(1, 0)(2, 1) = 0.25f;
  state.channel(1, 1)(2, 1) = 0.5f;
  state = change_channels(std::move(state), old, basis);
  ASSERT_EQ(state.channels, 7);
  EXPECT_FLOAT_EQ(state.channel(1, 0)(2, 1), 0.75f);  // the amount
  for (int band = 0; band < 3; ++band) {
    const double K = 0.25 * first[0].K(band) + 0.5 * first[1].K(band);
    EXPECT_NEAR(state.channel(1, 1 + band)(2, 1), K, 1e-6 * K);
  }
  EXPECT_FLOAT_EQ(state.channel(0, 0)(2, 1), 0.0f);
}

TEST(ChannelChange, OneNameCannotMeanTwoPaints) {
  EXPECT_FALSE(join_palettes({pigment_from_color("a", {0.1f, 0.2f, 0.3f})},
                             {pigment_from_color("a", {0.3f, 0.2f, 0.3f})})
                   .ok());
}

}  // namespace
}  // namespace pentimento
