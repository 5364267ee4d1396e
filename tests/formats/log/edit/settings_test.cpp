#include "formats/log/edit/settings.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(Settings, KeepsTheLastOfEachInTheOrderInWhichTheyWereSet) {
  Settings settings;
  for (const Event& event : {at(0, Slider{"size", 1}), at(1, BrushChange{"flat"}),
                             at(2, Slider{"pickup", 0.1}), at(3, Slider{"size", 2})})
    EXPECT_TRUE(settings.take(event));
  EXPECT_FALSE(settings.take(at(4, Dry{})));
  EXPECT_EQ(lines_of(settings.at(9'000'000)),
            lines_of({at(9, BrushChange{"flat"}), at(9, Slider{"pickup", 0.1}),
                      at(9, Slider{"size", 2})}));
  settings.clear();
  EXPECT_TRUE(settings.at(0).empty());
}

TEST(Settings, ABrushDippedInPartsKeepsThemUntilItIsDippedWhole) {
  const auto color = [](const char* name, bool part) {
    Color c;
    c.pigment = name;
    if (part) c.across = {{0.0, 0.5}};
    return at(1, c);
  };
  Settings settings;
  for (const Event& event : {color("red", false), color("blue", true), color("white", true)})
    settings.take(event);
  EXPECT_EQ(settings.at(0).size(), 3u);
  settings.take(color("green", false));
  EXPECT_EQ(lines_of(settings.at(1'000'000)), lines_of({color("green", false)}));
}

TEST(Settings, LightsAddUp) {
  Settings settings;
  Light direction, intensity;
  direction.direction = {{1, 0, 1}};
  intensity.intensity = 0.5;
  settings.take(at(0, direction));
  settings.take(at(1, intensity));
  EXPECT_EQ(lines_of(settings.at(0)), lines_of({at(0, direction), at(0, intensity)}));
}

}  // namespace
}  // namespace pentimento::log
