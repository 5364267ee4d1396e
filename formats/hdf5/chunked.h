#pragma once
// Writes large datasets of 4-byte values in compressed chunks. Several threads shuffle and deflate
// the chunks, which then go to HDF5 as they are. Any reader sees an ordinary dataset with shuffle +
// gzip.

#include <hdf5.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento::hdf5 {

/// A dataset as a list of rows. The last axis of `shape` is a row (for a shape of three axes the
/// last two, interleaved), and the axis before it counts the rows within a plane.
struct RowSource {
  std::vector<std::uint64_t> shape;  // (ny, nx), (ny, nx, bands) or (layers, channels, ny, nx)
  /// Copies values of row `row`, counted through all planes, from cell x on. A cell has several
  /// values if the shape has three axes. Called from several threads.
  std::function<void(std::int64_t row, int x, std::span<std::uint32_t> out)> copy;
  /// Cells along a chunk's side; 0: chunks of whole rows.
  std::uint64_t chunk_side = 0;
  /// May return true for a part of a plane whose values are all zero bits, which saves reading it.
  std::function<bool(const CellWindow&)> zero;
  /// Once it is set, no more chunks are written.
  const std::atomic<bool>* cancelled = nullptr;
};

/// The shape of the chunks of such a dataset; `chunk_side` and `shape` as in RowSource.
std::vector<hsize_t> chunk_shape(const std::vector<std::uint64_t>& shape, std::uint64_t chunk_side);

/// Creates and fills the dataset `name` of type `type` (4 bytes, native). Chunks of nothing but
/// zero bits are left out: they read as zero. Returns the dataset, or a negative number if HDF5
/// failed or the source is cancelled.
hid_t write_chunked(hid_t file, const std::string& name, hid_t type, const RowSource& source,
                    int deflate_level, const Threads& threads);

}  // namespace pentimento::hdf5
