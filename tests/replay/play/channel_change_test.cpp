#include "replay/play/channel_change.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

Pigment paint(const std::string& name, double k, double s) {
  return {name, Eigen::Vector3d(k, 2 * k, 3 * k), Eigen::Vector3d(s, s / 2, s / 4)};
}
std::vector<Pigment> paints(int count) {
  std::vector<Pigment> out;
  for (int i = 0; i < count; ++i)
    out.push_back(paint(std::string("paint ").append(std::to_string(i)), 0.1 * (i + 1), 0.5 + i));
  return out;
}

TEST(JoinPalettes, KeepsTheFirstInOrderAndAppendsWhatIsNew) {
  const auto joined =
      join_palettes(paints(2), {paint("new", 1, 1), paints(2)[1], paint("last", 2, 2)});
  ASSERT_TRUE(joined);
  std::vector<std::string> names;
  for (const Pigment& p : *joined) names.push_back(p.name);
  EXPECT_EQ(names, (std::vector<std::string>{"paint 0", "paint 1", "new", "last"}));
}

TEST(JoinPalettes, OneNameForTwoPaintsIsRefused) {
  Pigment other_k = paints(1)[0], other_s = other_k;
  other_k.K[2] += 1e-9;
  other_s.S[0] += 1e-9;
  EXPECT_FALSE(join_palettes(paints(1), {other_k}));
  EXPECT_FALSE(join_palettes(paints(1), {other_s}));
}

/// A canvas of which channel c of layer l holds l + 10 c + x everywhere in column x.
CanvasState painted(int channels) {
  CanvasState state = make_canvas_state({3, 2, 0.3, 0.2}, 2, channels, 3, 0.9f);
  for (int layer = 0; layer < 2; ++layer)
    for (int c = 0; c < channels; ++c)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
          state.channel(layer, c)(x, y) = static_cast<float>(layer + 10 * c + x);
  state.sleep = {1, 0, 0, 9.81f, 0};
  return state;
}

TEST(ChangeChannels, APigmentMoreLeavesTheOthersAndTheSleepAsTheyWere) {
  const ChannelBasis two = palette_channels(paints(2)), four = channels_after(two, paints(4));
  EXPECT_TRUE(channel_per_pigment(four));
  const CanvasState state = change_channels(painted(2), two, four);
  ASSERT_EQ(state.channels, 4);
  ASSERT_EQ(state.pigment.size(), 8u);
  for (int layer = 0; layer < 2; ++layer)
    for (int c = 0; c < 4; ++c)
      EXPECT_EQ(state.channel(layer, c)(2, 1), c < 2 ? static_cast<float>(layer + 10 * c + 2) : 0)
          << layer << " " << c;
  EXPECT_EQ(state.sleep.size(), 5u);
}

TEST(ChangeChannels, MoreThanEightBecomeOpticalAndWakeUp) {
  // Channels of optical kind: the amount, K and S of the paint that there is, by hand.
  const ChannelBasis two = palette_channels(paints(2)), many = channels_after(two, paints(9));
  EXPECT_FALSE(channel_per_pigment(many));
  ASSERT_EQ(many.channels(), 7);
  const CanvasState state = change_channels(painted(2), two, many);
  const double a = 1 + 2, b = 1 + 10 + 2;  // layer 1, column 2
  const double expected[] = {a + b,
                             0.1 * a + 0.2 * b,
                             0.2 * a + 0.4 * b,
                             0.3 * a + 0.6 * b,
                             0.5 * a + 1.5 * b,
                             0.25 * a + 0.75 * b,
                             0.125 * a + 0.375 * b};
  for (int c = 0; c < 7; ++c)
    EXPECT_FLOAT_EQ(state.channel(1, c)(2, 0), static_cast<float>(expected[c])) << c;
  EXPECT_TRUE(state.sleep.empty());
  // Once optical, always: even with a palette that would fit, and without a change.
  const ChannelBasis after = channels_after(many, paints(2));
  EXPECT_FALSE(channel_per_pigment(after));
  const CanvasState same = change_channels(painted(7), many, after);
  EXPECT_EQ(same.channel(1, 3)(2, 1), 33.0f);
  EXPECT_FALSE(same.sleep.empty());
}

}  // namespace
}  // namespace pentimento
