#include "replay/timeline/brush_track.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(BrushTrack, ABrushsOwnSpacingStandsBeforeTheSliders) {
  const BrushTable brushes;
  BrushTrack track(brushes);
  EXPECT_EQ(track.spacing_frac(),
            static_cast<double>(0.025f));  // docs/action-log.md: the slider's default
  EXPECT_EQ(track.diameter_m(), 0.03f);
  track.follow(log::Slider{"spacing", 0.2});
  track.follow(log::Slider{"size", 0.05});
  EXPECT_EQ(track.spacing_frac(), static_cast<double>(0.2f));
  EXPECT_EQ(track.diameter_m(), 0.05f);
  track.follow(log::BrushChange{"rag"});
  EXPECT_EQ(track.spacing_frac(), static_cast<double>(brushes.find("rag").spacing));
  EXPECT_NE(track.spacing_frac(), static_cast<double>(0.2f));
  track.follow(log::BrushChange{"round"});
  EXPECT_EQ(track.spacing_frac(), static_cast<double>(0.2f));
}

}  // namespace
}  // namespace pentimento
