#pragma once
// The detail canvas of a dump, read from the file part by part, so that shading and comparing large
// pictures never hold all of it. For this folder only.

#include <hdf5.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/canvas/canvas_source.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/packed_chunks.h"
#include "formats/hdf5/read_canvas.h"
#include "formats/hdf5/tile_cache.h"

namespace pentimento::hdf5 {

class DumpSource final : public CanvasSource {
 public:
  /// `shape` is what canvas_shape() found in the file. Holds the file open, also when `from` is
  /// closed; keeps up to `cache_bytes` of it in memory. Errors: kBadInput.
  static Result<std::shared_ptr<const DumpSource>> open(const DumpFile& from,
                                                        const CanvasShape& shape,
                                                        const CanvasGeometry& geometry,
                                                        std::int64_t step, std::size_t cache_bytes);

  const CanvasGeometry& geometry() const override { return geometry_; }
  int layers() const override { return shape_.layers; }
  int channels() const override { return shape_.channels; }
  int bands() const override { return shape_.bands; }
  std::int64_t step() const override { return step_; }
  void read(PlaneId plane, int x, int y, std::span<float> out) const override;
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override;
  bool empty(const CellWindow& window) const override;
  void expect(const CellWindow& window, std::span<const PlaneId> planes,
              const Threads& threads) const override;
  /// Error for the first part that could not be read or that has a value that is not finite or out
  /// of range.
  Result<void> status() const override;

 private:
  /// A tile is what one of the writer's chunks holds.
  struct TilePlace {
    std::size_t dataset = 0;  // index in kCanvasDatasets
    int plane = 0;            // within it
    int row = 0, column = 0;  // of tiles
    std::uint64_t key() const {
      return (std::uint64_t{dataset} << 56) | (static_cast<std::uint64_t>(plane) << 32) |
             (static_cast<std::uint64_t>(row) << 16) | static_cast<std::uint64_t>(column);
    }
  };
  DumpSource(std::string path, const CanvasShape& shape, const CanvasGeometry& geometry,
             std::int64_t step, std::size_t cache_bytes)
      : path_(std::move(path)),
        shape_(shape),
        geometry_(geometry),
        step_(step),
        tiles_(cache_bytes) {}
  /// Values of a tile, which is cut at the right and the lower edge: row after row, for each of the
  /// values that a cell has. A single one where all are alike.
  KeptTile tile(const TilePlace& place) const;
  KeptTile load(const TilePlace& place) const;
  bool load_packed(const TilePlace& place, TileValues& values) const;
  bool load_selected(const TilePlace& place, TileValues& values) const;
  int plane_in(const PlaneId& plane) const;
  /// Where the tile begins in its dataset.
  std::vector<hsize_t> offset_of(const TilePlace& place) const;
  /// A tile's cells.
  int width_of(const TilePlace& place) const;
  int height_of(const TilePlace& place) const;
  /// A part of a row. `value`: which of the values that each cell has.
  template <typename Value>
  void read_cells(std::size_t dataset, int plane, int value, int x, int y,
                  std::span<Value> out) const;

  std::string path_;
  CanvasShape shape_;
  CanvasGeometry geometry_;
  std::int64_t step_;
  Handle file_;
  std::vector<Handle> datasets_;
  std::vector<std::optional<PackedChunks>> packed_;  // per dataset
  mutable TileCache tiles_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::optional<Error> problem_;
};

}  // namespace pentimento::hdf5
