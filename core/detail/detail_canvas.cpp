#include "core/detail/detail_canvas.h"

namespace pentimento {

namespace {
template <typename Body>
void for_wet_planes(int pigments, const Body& body) {
  for (int p = -1; p < pigments; ++p) body(WetPlane{p});
}
}  // namespace

bool any_in(const Field<float>& plane, const GuideBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    const float* row = plane.row(y);
    for (int x = box.x0; x < box.x1; ++x)
      if (row[x] != 0) return true;
  }
  return false;
}

DetailTile& DetailCanvas::at(int tile) {
  std::unique_ptr<DetailTile>& slot = tile_[static_cast<std::size_t>(tile)];
  if (!slot) slot = std::make_unique<DetailTile>(tile, layout_.box(tile), layers_ * channels_);
  return *slot;
}

void DetailCanvas::clear() {
  for (auto& tile : tile_) tile.reset();
}

void DetailCanvas::cover(int tile, const CanvasState& guide) {
  const GuideBox box = layout_.box(tile);
  for_wet_planes(layers_ * channels_, [&](const WetPlane& q) {
    if (DetailTile* made = find(tile); made != nullptr && q.of(*made)) return;
    if (any_in(q.of(guide), box)) q.of(at(tile)).allocate(layout_.side());
  });
}

void DetailCanvas::prune(int tile, const CanvasState& guide) {
  DetailTile* made = find(tile);
  if (made == nullptr) return;
  for_wet_planes(layers_ * channels_, [&](const WetPlane& q) {
    if (q.of(*made) && !any_in(q.of(guide), made->box)) q.of(*made).free();
  });
}

}  // namespace pentimento
