#include "formats/log/edit/refit.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

TEST(Refit, FitsThePaintingIntoTheMiddleOfAnotherCanvas) {
  Header header;
  header.canvas_width_m = 1;
  header.canvas_height_m = 0.5;
  header.grid_width = 200;
  header.grid_height = 100;
  const Refit refit = fit_header(header, 0.5, 0.5);
  EXPECT_EQ(refit.scale, 0.5);
  EXPECT_EQ(refit.move_x_m, 0);
  EXPECT_EQ(refit.move_y_m, 0.125);
  // Cells of the painting stay its cells.
  EXPECT_EQ(header.grid_width, 200);
  EXPECT_EQ(header.grid_height, 200);
  EXPECT_EQ(header.canvas_height_m, 0.5);
}

TEST(Refit, ScalesPlacesAndSizes) {
  Event down = touch(1, TouchPhase::kDown, 0.5);
  std::get<Touch>(down.action).radius_m = 0.01;
  Event moved = touch(1, TouchPhase::kDown, 1.1);
  std::get<Touch>(moved.action).radius_m = 0.06;
  std::get<Touch>(moved.action).y_m = 0.2;
  Refit refit{2, 0.1, 0.2, 3};
  // The default size, 3 cm, is made larger too.
  EXPECT_EQ(
      edited<Refitted>({at(1, Slider{"size", 0.01}), at(1, Slider{"pickup", 0.5}), down}, refit),
      lines_of({at(0, Slider{"size", static_cast<double>(0.03f) * 6}), at(1, Slider{"size", 0.06}),
                at(1, Slider{"pickup", 0.5}), moved}));
  // No change, no event.
  EXPECT_EQ(edited<Refitted>({at(1, Dry{})}, Refit{}), lines_of({at(1, Dry{})}));
  // A slider stays in its range.
  EXPECT_EQ(edited<Refitted>({at(1, Slider{"size", 90})}, Refit{2, 0, 0, 1}).back(),
            event_json(at(1, Slider{"size", 100})));
}

}  // namespace
}  // namespace pentimento::log
