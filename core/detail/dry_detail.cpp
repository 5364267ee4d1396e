#include "core/detail/dry_detail.h"

#include <algorithm>

#include "core/simulation/drying.h"

namespace pentimento {

namespace {
FieldView<float> view_of(TilePlane& plane, int side) {
  return {plane.data(), side, side, side};
}

void copy(FieldView<const float> from, FieldView<float> to) {
  for (int y = 0; y < from.height(); ++y) std::copy_n(from.row(y), from.width(), to.row(y));
}

/// The ground's reflectance where nothing has dried yet.
bool find_reflectance(DetailCanvas& canvas, DetailTile& tile) {
  const int side = canvas.layout().side(), k = canvas.layout().factor();
  if (!tile.reflectance.empty()) return true;
  std::vector<TilePlane> bands(static_cast<std::size_t>(canvas.bands()));
  for (TilePlane& band : bands)
    if (!canvas.make(band)) return false;
  tile.reflectance = std::move(bands);
  for (std::size_t band = 0; band < tile.reflectance.size(); ++band) {
    const FieldView<float> plane = view_of(tile.reflectance[band], side);
    for (int y = 0; y < tile.box.height() * k; ++y)
      canvas.substrate().reflectance_row(
          static_cast<int>(band), tile.box.x0 * k, tile.box.y0 * k + y,
          {plane.row(y), static_cast<std::size_t>(tile.box.width() * k)});
  }
  return true;
}

/// A tile as a small canvas, for the code that dries the guide.
void dry_tile(DetailCanvas& canvas, DetailTile& tile, const ChannelBasis& basis,
              const Model& model) {
  if (!tile.depth_m || !tile.base_m || !find_reflectance(canvas, tile)) return;
  const int side = canvas.layout().side();
  CanvasState small = make_canvas_state({side, side, 1, 1}, canvas.layers(), canvas.channels(),
                                        canvas.bands(), 1.0f);
  copy(view_of(tile.depth_m, side), small.depth_m.view());
  copy(view_of(tile.base_m, side), small.base_m.view());
  for (std::size_t band = 0; band < tile.reflectance.size(); ++band)
    for (int y = 0; y < side; ++y)
      small.reflectance[band].write(0, y, view_of(tile.reflectance[band], side).row_span(y));
  for (std::size_t p = 0; p < tile.pigment.size(); ++p)
    if (tile.pigment[p]) copy(view_of(tile.pigment[p], side), small.pigment[p].view());
  PaintFlow dried;
  dried.channel.assign(static_cast<std::size_t>(canvas.channels()), 0.0);
  dry_canvas(small, basis, model, EdgeCells::kCovered, Threads(1), dried);
  copy(small.base_m.view(), view_of(tile.base_m, side));
  for (std::size_t band = 0; band < tile.reflectance.size(); ++band)
    for (int y = 0; y < side; ++y)
      small.reflectance[band].read(0, y, view_of(tile.reflectance[band], side).row_span(y));
  tile.depth_m.free();
  for (TilePlane& plane : tile.pigment) plane.free();
  tile.open = {};
}
}  // namespace

void dry_detail(DetailCanvas& canvas, const ChannelBasis& basis, const Model& model,
                const Threads& threads) {
  threads.for_ranges(0, canvas.layout().tiles(), 4, [&](int begin, int end) {
    for (int t = begin; t < end; ++t)
      if (DetailTile* tile = canvas.find(t)) dry_tile(canvas, *tile, basis, model);
  });
}

}  // namespace pentimento
