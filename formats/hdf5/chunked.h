#pragma once
// Large datasets of 4-byte values in compressed chunks: shuffled and deflated by several threads,
// then handed to HDF5 whole. The file is an ordinary shuffle + gzip dataset for any reader.

#include <hdf5.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento::hdf5 {

/// A dataset as a pile of rows: the last axis of `shape` (the last two, interleaved, for a shape of
/// three) is a row, and the axis before it the row within a plane.
struct RowSource {
  std::vector<std::uint64_t> shape;  // (ny, nx), (ny, nx, bands) or (layers, channels, ny, nx)
  /// Copies values of row `row` (counted through all planes) from cell x on; a cell has several
  /// values where the shape has three axes. Called from several threads.
  std::function<void(std::int64_t row, int x, std::span<std::uint32_t> out)> copy;
  /// Cells along a chunk's side; 0: chunks of whole rows.
  std::uint64_t chunk_side = 0;
  /// May say of a part of a plane that all its values are zero bits, to save reading them.
  std::function<bool(const CellWindow&)> zero;
};

/// Creates and fills the dataset `name` of type `type` (4 bytes, native). Chunks of nothing but
/// zero bits are left out: they read as zero. Returns the dataset, or a negative number.
hid_t write_chunked(hid_t file, const std::string& name, hid_t type, const RowSource& source,
                    int deflate_level, const Threads& threads);

}  // namespace pentimento::hdf5
