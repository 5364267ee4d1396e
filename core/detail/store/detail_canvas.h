#pragma once
// The tiles of the detail canvas, made where paint comes. Who changes them is decided by the other
// files of this folder.

#include <memory>
#include <mutex>
#include <vector>

#include "core/detail/store/detail_layout.h"
#include "core/detail/store/detail_substrate.h"
#include "core/detail/store/detail_tile.h"

namespace pentimento {

class DetailCanvas {
 public:
  /// `substrate` and `store` (of buffers of side x side floats) outlive the canvas.
  DetailCanvas(const DetailLayout& layout, int layers, int channels, int bands,
               const DetailSubstrate& substrate, TileStore& store)
      : layout_(layout),
        substrate_(substrate),
        store_(store),
        layers_(layers),
        channels_(channels),
        bands_(bands) {
    tile_.resize(static_cast<std::size_t>(layout.tiles()));
  }

  const DetailLayout& layout() const { return layout_; }
  const DetailSubstrate& substrate() const { return substrate_; }
  int layers() const { return layers_; }
  int channels() const { return channels_; }
  int bands() const { return bands_; }
  /// nullptr where there never was paint.
  DetailTile* find(int tile) { return tile_[static_cast<std::size_t>(tile)].get(); }
  const DetailTile* find(int tile) const { return tile_[static_cast<std::size_t>(tile)].get(); }
  /// Makes the tile, with the relief of the fresh paper, if it does not exist.
  DetailTile& at(int tile);
  /// Back to bare paper.
  void clear();

  /// The tile has a plane for everything that the guide has in it, or in the part `box` of it.
  void ensure_planes(int tile, const CanvasState& guide) {
    ensure_planes(tile, guide, layout_.box(tile));
  }
  void ensure_planes(int tile, const CanvasState& guide, const CellBox& box);
  /// Gives `plane` memory, zero everywhere. False if there is none: problem() says why from then
  /// on, and the canvas shows less than was painted. From any thread.
  bool make(TilePlane& plane);
  /// The first failure to get memory or disk, if any.
  const Result<void>& problem() const { return problem_; }
  /// Everything in the tile is in use now.
  void mark_used(int tile) const;
  /// Lets go of memory that was not used lately, as far as the store is told to.
  void trim() const { store_.trim(); }

  /// Channels of which the tile has a plane, ascending; each gets planes for all layers.
  std::vector<int> complete_channels(int tile);
  /// Frees wet planes of the tile in which neither the guide nor the tile has anything.
  void prune(int tile, const CanvasState& guide);

 private:
  DetailLayout layout_;
  const DetailSubstrate& substrate_;
  TileStore& store_;
  std::mutex mutex_;
  Result<void> problem_;
  int layers_, channels_, bands_;
  std::vector<std::unique_ptr<DetailTile>> tile_;
};

/// Whether the guide has any of the quantity in the box.
bool any_in(const Field<float>& plane, const CellBox& box);

}  // namespace pentimento
