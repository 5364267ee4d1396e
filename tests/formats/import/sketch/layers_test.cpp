#include "formats/import/sketch/layers.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

Stroke on_layer(int layer, double x) {
  Stroke stroke;
  stroke.layer = layer;
  stroke.samples = {{.x = x}};
  return stroke;
}
/// x of strokes, -1 for a drying.
std::vector<double> order_of(const Sketch& sketch) {
  std::vector<double> out;
  for (const Item& item : sketch.items) {
    const auto* stroke = std::get_if<Stroke>(&item);
    if (stroke == nullptr) {
      EXPECT_EQ(std::get<SketchAction>(item), SketchAction::kDry);
    }
    out.push_back(stroke == nullptr ? -1 : stroke->samples[0].x);
  }
  return out;
}

TEST(Layers, LieOneOverTheOtherAndDryBetween) {
  Sketch sketch;
  sketch.items = {on_layer(2, 1), on_layer(0, 2), on_layer(2, 3), on_layer(1, 4), on_layer(0, 5)};
  EXPECT_EQ(paint_layer_by_layer(sketch), 3);
  EXPECT_EQ(order_of(sketch), (std::vector<double>{2, 5, -1, 4, -1, 1, 3}));
}

TEST(Layers, OneLayerStaysAsItIs) {
  Sketch sketch;
  EXPECT_EQ(paint_layer_by_layer(sketch), 0);
  sketch.items = {on_layer(7, 1), on_layer(7, 2)};
  EXPECT_EQ(paint_layer_by_layer(sketch), 1);
  EXPECT_EQ(order_of(sketch), (std::vector<double>{1, 2}));
}

TEST(Layers, UndoCountsOnTheOrder) {
  Sketch sketch;
  sketch.items = {on_layer(1, 1), on_layer(0, 2), SketchAction::kUndo};
  EXPECT_EQ(paint_layer_by_layer(sketch), 1);
  EXPECT_EQ(std::get<Stroke>(sketch.items[0]).layer, 1);
}

}  // namespace
}  // namespace pentimento::sketch
