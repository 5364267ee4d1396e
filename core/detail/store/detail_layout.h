#pragma once
// How the detail canvas lies over the guide. Every cell of the guide is a block of factor x factor
// fine cells. Tiles of whole blocks are stored and worked on together. Pure geometry.

#include <algorithm>

#include "core/base/check.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"

namespace pentimento {

inline constexpr int kMostDetail = 32;
inline constexpr int kMostTileSide = 128;  // fine cells

class DetailLayout {
 public:
  /// `factor`: the detail, in [1, kMostDetail]. A tile is about 128 fine cells wide, and at least
  /// two blocks.
  DetailLayout(const CanvasGeometry& guide, int factor) : guide_(guide), factor_(factor) {
    PENTIMENTO_CHECK(factor >= 1 && factor <= kMostDetail);
    blocks_ = std::max(2, kMostTileSide / factor);
    columns_ = (guide.width + blocks_ - 1) / blocks_;
    rows_ = (guide.height + blocks_ - 1) / blocks_;
  }

  const CanvasGeometry& guide() const { return guide_; }
  int factor() const { return factor_; }
  /// Guide cells along a tile's side.
  int blocks() const { return blocks_; }
  /// Fine cells along a tile's side. Tiles at the right and the lower edge are stored whole.
  int side() const { return blocks_ * factor_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int tiles() const { return columns_ * rows_; }
  int tile_of(int column, int row) const { return row * columns_ + column; }
  /// The part of the guide that a tile covers.
  CellBox box(int tile) const {
    const int x = tile % columns_ * blocks_, y = tile / columns_ * blocks_;
    return {x, std::min(x + blocks_, guide_.width), y, std::min(y + blocks_, guide_.height)};
  }
  CanvasGeometry fine() const {
    return {guide_.width * factor_, guide_.height * factor_, guide_.width_m, guide_.height_m};
  }

 private:
  CanvasGeometry guide_;
  int factor_;
  int blocks_;
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace pentimento
