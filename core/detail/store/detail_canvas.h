#pragma once
// The detail canvas: its tiles, which are made where paint comes. Other files change what is in
// them: stamp/, flow/ and lock/ beside this folder.

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/detail/store/detail_layout.h"
#include "core/detail/store/detail_substrate.h"
#include "core/detail/store/detail_tile.h"

namespace pentimento {

class DetailCanvas {
 public:
  /// `substrate` and `store` must outlive the canvas. A buffer of `store` has side() x side()
  /// floats.
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
  /// The tile, or nullptr if it never had paint.
  DetailTile* find(int tile) { return tile_[static_cast<std::size_t>(tile)].get(); }
  const DetailTile* find(int tile) const { return tile_[static_cast<std::size_t>(tile)].get(); }
  /// The tile. If it does not exist, it is made, with the relief of the fresh paper.
  DetailTile& at(int tile);
  /// Back to bare paper.
  void clear();

  /// Makes the planes that a tile lacks of what the guide has in the tile, or in the part `box` of
  /// it.
  void ensure_planes(int tile, const CanvasState& guide) {
    ensure_planes(tile, guide, layout_.box(tile));
  }
  void ensure_planes(int tile, const CanvasState& guide, const CellBox& box);
  /// Gives `plane` a buffer, zero everywhere. Returns false if there is none left; then problem()
  /// says why, and the canvas shows less than was painted. May be called from any thread.
  bool make(TilePlane& plane);
  /// Gives the wet planes of the tiles all their memory (TileStore::give_memory()). Call it before
  /// work that reads and writes them.
  void give_memory(std::span<const int> tiles, const Threads& threads);
  /// The first failure to get memory or disk, if any.
  const Result<void>& problem() const { return problem_; }
  /// Notes that all planes of the tile are in use now.
  void mark_used(int tile) const;
  /// Whether there is memory that trim() gives back.
  bool gives_back() const { return store_.gives_back(); }
  /// Gives back memory that was not used lately (TileStore::trim()).
  void trim() const { store_.trim(); }

  /// The channels of which the tile has a plane, ascending. Each of them gets planes for all
  /// layers.
  std::vector<int> complete_channels(int tile);
  /// Frees the wet planes of the tile that are zero both in the tile and, in its cells, on the
  /// guide.
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

/// Whether `plane` has a value that is not 0 in the box.
bool any_in(const Field<float>& plane, const CellBox& box);

}  // namespace pentimento
