#pragma once
// One tile of the detail canvas. A plane exists only while it is needed: depth and pigments while
// the tile is wet, reflectance once something has dried.

#include <cstdint>
#include <utility>
#include <vector>

#include "core/canvas/tile_store.h"
#include "core/detail/store/block_layers.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// A plane of a tile: side x side floats of a TileStore, row by row. It may be absent; that means
/// zero everywhere, or for reflectance the fresh ground. Move-only; its destructor frees the
/// buffer.
class TilePlane {
 public:
  TilePlane() = default;
  TilePlane(TilePlane&& other) noexcept { *this = std::move(other); }
  TilePlane& operator=(TilePlane&& other) noexcept {
    std::swap(store_, other.store_);
    std::swap(buffer_, other.buffer_);
    std::swap(data_, other.data_);
    std::swap(given_, other.given_);
    return *this;
  }
  ~TilePlane() { free(); }

  explicit operator bool() const { return data_ != nullptr; }
  float* data() { return data_; }
  const float* data() const { return data_; }
  /// Gets a buffer of zeros. Errors: those of the store; then the plane stays absent.
  Result<void> allocate(TileStore& store) {
    Result<TileStore::Buffer> buffer = store.allocate();
    if (!buffer) return buffer.error();
    free();
    store_ = &store;
    buffer_ = *buffer;
    data_ = store.data(buffer_);
    return {};
  }
  void free() {
    if (data_ != nullptr) store_->free(buffer_);
    data_ = nullptr;
    given_ = false;
  }
  /// TileStore::give_memory(), once.
  void give_memory() {
    if (data_ == nullptr || given_) return;
    store_->give_memory(buffer_);
    given_ = true;
  }
  /// Notes that the plane is in use now.
  void mark_used() const {
    if (data_ != nullptr) store_->mark_used(buffer_);
  }

 private:
  TileStore* store_ = nullptr;
  TileStore::Buffer buffer_ = 0;
  float* data_ = nullptr;
  bool given_ = false;  // its memory
};

/// Which fine cells have opened a layer for the stroke for which their guide cell opened one. The
/// edge of a stroke runs through blocks, and cells that the tip does not touch keep their layers.
struct OpenCells {
  std::vector<std::uint8_t> opened;      // per fine cell, side x side
  std::vector<LayerOpening> opening;     // per block: what opening its cells does
  std::vector<std::uint8_t> mismatched;  // per block: layers no longer correspond to the guide's
  bool empty() const { return opened.empty(); }
};

struct DetailTile {
  DetailTile(int index, const CellBox& covers, int planes) : tile(index), box(covers) {
    pigment.resize(static_cast<std::size_t>(planes));
  }
  int tile;     // index in the layout
  CellBox box;  // of the guide
  TilePlane depth_m;
  std::vector<TilePlane> pigment;      // [layer * channels + channel]
  OpenCells open;                      // empty: all are open
  TilePlane base_m;                    // paper and dried paint
  std::vector<TilePlane> reflectance;  // of the dry layer, per band; absent: fresh ground
};

/// One wet quantity: the depth, or a pigment plane.
struct WetPlane {
  int pigment = -1;  // [layer * channels + channel]; -1 is the depth
  TilePlane& of(DetailTile& tile) const {
    return pigment < 0 ? tile.depth_m : tile.pigment[static_cast<std::size_t>(pigment)];
  }
  const Field<float>& of(const CanvasState& guide) const {
    return pigment < 0 ? guide.depth_m : guide.pigment[static_cast<std::size_t>(pigment)];
  }
};

}  // namespace pentimento
