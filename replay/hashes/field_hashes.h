#pragma once
// Hashes of a state's fields, tile by tile, kept up to date from step to step at little cost: only
// tiles that may have changed are hashed again.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"

namespace pentimento {

/// The fields, in this order, by their names in a dump.
inline constexpr std::array<const char*, 8> kHashedFields = {
    "/fluid/depth",        "/fluid/velocity_x", "/fluid/velocity_y", "/canvas/base",
    "/canvas/reflectance", "/layers/pigment",   "/layers/stroke",    "/fluid/asleep"};

using FieldHashArray = std::array<std::uint64_t, kHashedFields.size()>;

/// A tile whose content changed, and the hash of all its fields.
struct TileHash {
  int tile = 0;
  std::uint32_t hash = 0;
  friend bool operator==(const TileHash&, const TileHash&) = default;
};

class FieldHashes {
 public:
  /// The tiles are those that sleep and wake (core/fluid/conservative/tiles/sleep_tiles.h).
  FieldHashes(const CanvasGeometry& geometry, float sleep_tile_m);

  /// Hashes the tiles of `state` that may have changed since the last call: those that are awake or
  /// were then. With `all`, and at the first call, every tile is hashed. What lies under the wet
  /// paint, base and reflectance, is looked at only then.
  void update(const CanvasState& state, const Threads& threads, bool all = false);

  /// A hash of each field over the whole canvas. XXH3 of 64 bits: equal where the bits are.
  const FieldHashArray& fields() const { return fields_; }
  /// Tiles that the last update found changed, in order.
  const std::vector<TileHash>& changed() const { return changed_; }
  CellBox box(int tile) const;
  int tile_width() const { return tile_width_; }
  int tile_height() const { return tile_height_; }

 private:
  bool may_have_changed(const CanvasState& state, int tile) const;

  CanvasGeometry geometry_;
  int columns_, rows_, tile_width_, tile_height_;
  std::vector<FieldHashArray> tiles_;
  std::vector<std::uint8_t> was_awake_;  // at the last update
  bool is_first_ = true;
  FieldHashArray fields_{};
  std::vector<TileHash> changed_;
};

}  // namespace pentimento
