#include "core/detail/store/detail_canvas.h"

#include <algorithm>

namespace pentimento {

namespace {
template <typename Body>
void for_wet_planes(int pigments, const Body& body) {
  for (int p = -1; p < pigments; ++p) body(WetPlane{p});
}

/// Mismatched blocks may have paint in layers where the guide has none.
bool any_in(const TilePlane& plane, const DetailLayout& layout) {
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(layout.side()) * layout.side();
  return std::any_of(plane.data(), plane.data() + cells, [](float v) { return v != 0; });
}
}  // namespace

bool any_in(const Field<float>& plane, const CellBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    const float* row = plane.row(y);
    for (int x = box.x0; x < box.x1; ++x)
      if (row[x] != 0) return true;
  }
  return false;
}

DetailTile& DetailCanvas::at(int tile) {
  std::unique_ptr<DetailTile>& slot = tile_[static_cast<std::size_t>(tile)];
  if (slot) return *slot;
  slot = std::make_unique<DetailTile>(tile, layout_.box(tile), layers_ * channels_);
  const int side = layout_.side(), k = layout_.factor();
  const CellBox& box = slot->box;
  if (!make(slot->base_m)) return *slot;
  for (int y = 0; y < box.height() * k; ++y)
    substrate_.relief_row(box.x0 * k, box.y0 * k + y,
                          {slot->base_m.data() + static_cast<std::ptrdiff_t>(y) * side,
                           static_cast<std::size_t>(box.width() * k)});
  return *slot;
}

bool DetailCanvas::make(TilePlane& plane) {
  const Result<void> made = plane.allocate(store_);
  if (made) return true;
  const std::lock_guard<std::mutex> guard(mutex_);
  if (problem_) problem_ = made.error();
  return false;
}

void DetailCanvas::mark_used(int tile) const {
  if (!store_.gives_back()) return;
  const DetailTile* made = find(tile);
  if (made == nullptr) return;
  made->depth_m.mark_used();
  made->base_m.mark_used();
  for (const TilePlane& plane : made->pigment) plane.mark_used();
  for (const TilePlane& plane : made->reflectance) plane.mark_used();
}

void DetailCanvas::give_memory(std::span<const int> tiles, const Threads& threads) {
  threads.for_ranges(0, static_cast<int>(tiles.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      DetailTile* made = find(tiles[static_cast<std::size_t>(i)]);
      if (made == nullptr) continue;
      made->depth_m.give_memory();
      for (TilePlane& plane : made->pigment) plane.give_memory();
    }
  });
}

void DetailCanvas::clear() {
  for (auto& tile : tile_) tile.reset();
}

void DetailCanvas::ensure_planes(int tile, const CanvasState& guide, const CellBox& box) {
  for_wet_planes(layers_ * channels_, [&](const WetPlane& q) {
    if (DetailTile* made = find(tile); made != nullptr && q.of(*made)) return;
    if (any_in(q.of(guide), box)) make(q.of(at(tile)));
  });
}

std::vector<int> DetailCanvas::complete_channels(int tile) {
  std::vector<int> channels;
  DetailTile* made = find(tile);
  if (made == nullptr) return channels;
  const auto plane = [&](int layer, int c) -> TilePlane& {
    return made->pigment[static_cast<std::size_t>(layer * channels_ + c)];
  };
  for (int c = 0; c < channels_; ++c) {
    bool any = false;
    for (int layer = 0; layer < layers_; ++layer) any |= static_cast<bool>(plane(layer, c));
    if (!any) continue;
    bool all = true;
    for (int layer = 0; layer < layers_; ++layer)
      all &= static_cast<bool>(plane(layer, c)) || make(plane(layer, c));
    if (all) channels.push_back(c);
  }
  return channels;
}

void DetailCanvas::prune(int tile, const CanvasState& guide) {
  DetailTile* made = find(tile);
  if (made == nullptr) return;
  for_wet_planes(layers_ * channels_, [&](const WetPlane& q) {
    const TilePlane& plane = q.of(*made);
    if (plane && !any_in(q.of(guide), made->box) && !any_in(plane, layout_)) q.of(*made).free();
  });
}

}  // namespace pentimento
