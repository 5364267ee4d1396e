#include "formats/import/sketch/layers.h"

#include <algorithm>

namespace pentimento::sketch {

namespace {
int layer_of(const Item& item) {
  return std::get<Stroke>(item).layer;
}
}  // namespace

int paint_layer_by_layer(Sketch& sketch) {
  std::vector<Item>& items = sketch.items;
  for (const Item& item : items)
    if (!std::holds_alternative<Stroke>(item)) return 1;
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return layer_of(a) < layer_of(b); });
  std::vector<Item> coats;
  int layers = 0;
  for (Item& item : items) {
    const bool new_layer = layers == 0 || layer_of(item) != layer_of(coats.back());
    if (new_layer && layers++ > 0) coats.emplace_back(SketchAction::kDry);
    coats.push_back(std::move(item));
  }
  items = std::move(coats);
  return layers;
}

}  // namespace pentimento::sketch
