#include "core/detail/prolong_guide.h"

#include <algorithm>

#include "core/detail/store/block_rows.h"

namespace pentimento {

namespace {
/// The guide's plane, bilinear, in the tile's cells.
void enlarge(const Field<float>& guide, DetailCanvas& canvas, const DetailTile& tile,
             TilePlane& plane) {
  const int side = canvas.layout().side();
  if (!plane && !canvas.make(plane)) return;
  std::fill_n(plane.data(), static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 1.0f);
  std::vector<float> mean(static_cast<std::size_t>(tile.box.width()));
  for (int y = tile.box.y0; y < tile.box.y1; ++y) {
    const BlockStrip strip = {tile.tile, y, tile.box.x0, tile.box.x1};
    RatiosAround value;
    read_around(guide, strip, value);
    scale_by_field(value.from(0), block_row(plane.data(), canvas.layout(), strip), mean);
  }
}

bool has_dried(const Field<float>& dried_m, const CellBox& box) {
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
      if (dried_m(x, y) != 0) return true;
  return false;
}

/// What has dried on the paper, m.
Field<float> dried_on(const CanvasState& guide) {
  Field<float> dried_m(guide.geometry.width, guide.geometry.height);
  std::vector<float> paper_m(static_cast<std::size_t>(dried_m.width()));
  for (int y = 0; y < dried_m.height(); ++y) {
    read_paper(guide, 0, y, paper_m);
    for (int x = 0; x < dried_m.width(); ++x)
      dried_m(x, y) = guide.base_m(x, y) - paper_m[static_cast<std::size_t>(x)];
  }
  return dried_m;
}

void restore_dry(const Field<float>& dried_m, DetailCanvas& canvas, int index) {
  DetailTile& tile = canvas.at(index);
  const int side = canvas.layout().side();
  TilePlane dried;
  enlarge(dried_m, canvas, tile, dried);
  if (!dried || !tile.base_m) return;
  for (int i = 0; i < side * side; ++i) tile.base_m.data()[i] += dried.data()[i];
  tile.reflectance.resize(static_cast<std::size_t>(canvas.bands()));
  for (TilePlane& band : tile.reflectance)
    if (!canvas.make(band)) return;
}

/// Band after band, for in one plane of its own each is as large as the guide.
void restore_reflectance(const CanvasState& guide, DetailCanvas& canvas, const Threads& threads) {
  for (std::size_t band = 0; band < guide.reflectance.size(); ++band) {
    const Field<float> values = guide.reflectance[band].values();
    threads.for_ranges(0, canvas.layout().tiles(), 4, [&](int begin, int end) {
      for (int t = begin; t < end; ++t)
        if (DetailTile* tile = canvas.find(t); tile != nullptr && !tile->reflectance.empty())
          enlarge(values, canvas, *tile, tile->reflectance[band]);
    });
  }
}
}  // namespace

void prolong_guide(DetailCanvas& canvas, const CanvasState& guide, const Threads& threads) {
  const DetailLayout& layout = canvas.layout();
  const Field<float> dried_m = dried_on(guide);
  threads.for_ranges(0, layout.tiles(), 4, [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      if (has_dried(dried_m, layout.box(t))) restore_dry(dried_m, canvas, t);
      canvas.ensure_planes(t, guide);
      DetailTile* tile = canvas.find(t);
      if (tile == nullptr) continue;
      if (tile->depth_m) enlarge(guide.depth_m, canvas, *tile, tile->depth_m);
      for (std::size_t p = 0; p < tile->pigment.size(); ++p)
        if (tile->pigment[p]) enlarge(guide.pigment[p], canvas, *tile, tile->pigment[p]);
    }
  });
  restore_reflectance(guide, canvas, threads);
}

}  // namespace pentimento
