#pragma once
// Large datasets of 4-byte values in compressed chunks: shuffled and deflated by several threads,
// then handed to HDF5 whole. The file is an ordinary shuffle + gzip dataset for any reader.

#include <hdf5.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/threads.h"

namespace pentimento::hdf5 {

/// A dataset as a pile of rows: the last axis of `shape` (the last two, interleaved, for a shape of
/// three) is a row, and the axis before it the row within a plane.
struct RowSource {
  std::vector<std::uint64_t> shape;  // (ny, nx), (ny, nx, bands) or (layers, channels, ny, nx)
  /// Copies row `row` (counted through all planes). Called from several threads.
  std::function<void(std::int64_t row, std::span<std::uint32_t> out)> copy;
};

/// Creates and fills the dataset `name` of type `type` (4 bytes, native). Chunks of nothing but
/// zero bits are left out: they read as zero. Returns the dataset, or a negative number.
hid_t write_chunked(hid_t file, const std::string& name, hid_t type, const RowSource& source,
                    int deflate_level, const Threads& threads);

}  // namespace pentimento::hdf5
