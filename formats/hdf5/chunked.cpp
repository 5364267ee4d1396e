#include "formats/hdf5/chunked.h"

#include <algorithm>
#include <cstring>

#include "core/check.h"
#include "formats/hdf5/handle.h"
#include "formats/io/deflate.h"

namespace pentimento::hdf5 {

namespace {

constexpr std::uint64_t kChunkValues = 65536;  // 256 KiB: inside the second-level cache
constexpr int kChunksAtOnce = 64;              // bounds the memory that compressed chunks take
constexpr std::size_t kValueBytes = 4;

using Bytes = std::vector<std::uint8_t>;

/// Chunks are whole rows of one plane.
struct Grid {
  std::uint64_t planes = 1, ny = 0, row = 0;  // `row`: values of a row
  std::uint64_t chunk_ny = 0;
  bool empty() const { return planes == 0 || ny == 0 || row == 0; }
  std::uint64_t down() const { return (ny + chunk_ny - 1) / chunk_ny; }
  std::uint64_t count() const { return empty() ? 0 : planes * down(); }
};

Grid grid_of(const std::vector<std::uint64_t>& shape) {
  Grid grid;
  if (shape.size() == 3) {
    grid.ny = shape[0];
    grid.row = shape[1] * shape[2];
  } else {
    grid.ny = shape[shape.size() - 2];
    grid.row = shape.back();
    for (std::size_t i = 0; i + 2 < shape.size(); ++i) grid.planes *= shape[i];
  }
  if (!grid.empty())
    grid.chunk_ny = std::min(grid.ny, std::max<std::uint64_t>(1, kChunkValues / grid.row));
  return grid;
}

std::vector<hsize_t> chunk_shape(const Grid& grid, const std::vector<std::uint64_t>& shape) {
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  if (shape.size() == 4) chunk[0] = chunk[1] = 1;
  chunk[shape.size() == 3 ? 0 : shape.size() - 2] = grid.chunk_ny;
  return chunk;
}

std::vector<hsize_t> chunk_offset(const Grid& grid, const std::vector<std::uint64_t>& shape,
                                  std::uint64_t chunk) {
  const std::uint64_t y = chunk % grid.down() * grid.chunk_ny;
  const std::uint64_t plane = chunk / grid.down();
  if (shape.size() == 3) return {y, 0, 0};
  if (shape.size() == 2) return {y, 0};
  return {plane / shape[1], plane % shape[1], y, 0};
}

/// HDF5's shuffle filter: first bytes of all values, then the second bytes, ...
Bytes shuffled(const std::vector<std::uint32_t>& values) {
  Bytes in(values.size() * kValueBytes);
  std::memcpy(in.data(), values.data(), in.size());
  Bytes out(in.size());
  const std::size_t n = values.size();
  for (std::size_t b = 0; b < kValueBytes; ++b)
    for (std::size_t i = 0; i < n; ++i) out[b * n + i] = in[i * kValueBytes + b];
  return out;
}

/// The chunk's values, compressed; empty for a chunk of zero bits. The last chunk of a plane is as
/// tall as the others, zeros below the plane.
Bytes compressed_chunk(const RowSource& source, const Grid& grid, std::uint64_t chunk, int level) {
  const std::uint64_t y0 = chunk % grid.down() * grid.chunk_ny;
  const std::uint64_t plane = chunk / grid.down();
  const std::uint64_t rows = std::min(grid.chunk_ny, grid.ny - y0);
  std::vector<std::uint32_t> values(grid.chunk_ny * grid.row);
  for (std::uint64_t y = 0; y < rows; ++y)
    source.copy(static_cast<std::int64_t>(plane * grid.ny + y0 + y),
                std::span(values).subspan(y * grid.row, grid.row));
  const bool zero = std::all_of(values.begin(), values.end(), [](auto v) { return v == 0; });
  return zero ? Bytes() : zlib_stream(shuffled(values), level);
}

Handle creation_list(const Grid& grid, const std::vector<std::uint64_t>& shape, int level) {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list.id(), false);  // equal states give equal bytes
  if (grid.empty()) return list;
  H5Pset_chunk(list.id(), static_cast<int>(shape.size()), chunk_shape(grid, shape).data());
  H5Pset_shuffle(list.id());
  H5Pset_deflate(list.id(), static_cast<unsigned>(level));
  return list;
}

bool write_chunks(hid_t dataset, const RowSource& source, const Grid& grid, int level,
                  const Threads& threads) {
  const int count = static_cast<int>(grid.count());
  for (int first = 0; first < count; first += kChunksAtOnce) {
    const int n = std::min(kChunksAtOnce, count - first);
    std::vector<Bytes> bytes(static_cast<std::size_t>(n));
    threads.for_ranges(0, n, 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        bytes[static_cast<std::size_t>(i)] =
            compressed_chunk(source, grid, static_cast<std::uint64_t>(first + i), level);
    });
    for (int i = 0; i < n; ++i) {
      const Bytes& chunk = bytes[static_cast<std::size_t>(i)];
      if (chunk.empty()) continue;
      const std::vector<hsize_t> offset =
          chunk_offset(grid, source.shape, static_cast<std::uint64_t>(first + i));
      if (H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, offset.data(), chunk.size(), chunk.data()) < 0)
        return false;
    }
  }
  return true;
}

}  // namespace

hid_t write_chunked(hid_t file, const std::string& name, hid_t type, const RowSource& source,
                    int deflate_level, const Threads& threads) {
  PENTIMENTO_CHECK(source.shape.size() >= 2 && source.shape.size() <= 4);
  const Grid grid = grid_of(source.shape);
  const std::vector<hsize_t> shape(source.shape.begin(), source.shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose);
  const Handle list = creation_list(grid, source.shape, deflate_level);
  Handle dataset(
      H5Dcreate2(file, name.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
      H5Dclose);
  if (!dataset.ok()) return dataset.release();
  if (!write_chunks(dataset.id(), source, grid, deflate_level, threads)) return -1;
  return dataset.release();
}

}  // namespace pentimento::hdf5
