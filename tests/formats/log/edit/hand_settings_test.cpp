#include "formats/log/edit/hand_settings.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

Color paint(const std::string& pigment, std::optional<std::array<double, 2>> across = {}) {
  Color color;
  color.pigment = pigment;
  color.across = across;
  return color;
}

TEST(HandSettings, BeginAsALogDoes) {
  HandSettings hand((Header()));
  EXPECT_TRUE(hand.changes_from(HandSettings(Header()), 0).empty());
  // What says the defaults changes nothing.
  hand.take(at(0, Slider{"size", 0.03}));
  hand.take(at(0, Slider{"pickup", 0.3}));
  hand.take(at(0, Slider{"load", 1}));
  hand.take(at(0, BrushChange{"round"}));
  hand.take(at(0, paint("Ivory Black")));
  EXPECT_TRUE(hand.changes_from(HandSettings(Header()), 0).empty());
  Header own;
  own.palette.resize(1);
  own.palette[0].name = "red";
  EXPECT_EQ(lines_of(HandSettings(own).changes_from(HandSettings(Header()), 7'000'000)),
            lines_of({at(7, paint("red"))}));
}

TEST(HandSettings, SendWhatDiffersOnly) {
  HandSettings left((Header())), right((Header()));
  EXPECT_TRUE(left.take(at(1, BrushChange{"flat"})));
  EXPECT_TRUE(left.take(at(2, Slider{"size", 0.1})));
  EXPECT_TRUE(right.take(at(2, Slider{"pigment", 0.2})));
  EXPECT_FALSE(left.take(at(3, Slider{"g", 2}))) << "of the model";
  EXPECT_FALSE(left.take(at(3, Dry{})));
  EXPECT_EQ(lines_of(left.changes_from(right, 0)),
            lines_of({at(0, BrushChange{"flat"}), at(0, Slider{"pigment", 0.7}),
                      at(0, Slider{"size", 0.1})}));
}

TEST(HandSettings, SendAllColoursOfADippedWidth) {
  HandSettings left((Header())), right((Header()));
  left.take(at(0, paint("red")));
  left.take(at(0, paint("blue", std::array{0.5, 1.0})));
  right.take(at(0, paint("red")));
  EXPECT_EQ(lines_of(left.changes_from(right, 0)),
            lines_of({at(0, paint("red")), at(0, paint("blue", std::array{0.5, 1.0}))}));
  left.take(at(0, paint("red")));
  EXPECT_TRUE(left.changes_from(right, 0).empty()) << "a whole dip ends the parts";
}

}  // namespace
}  // namespace pentimento::log
