#include "formats/hdf5/chunked.h"

#include <algorithm>
#include <cstring>

#include "core/base/check.h"
#include "core/base/interruption.h"
#include "formats/hdf5/handle.h"
#include "formats/io/deflate.h"

namespace pentimento::hdf5 {

namespace {

constexpr std::uint64_t kChunkValues = 65536;  // in chunks of whole rows: 256 KiB, inside the cache
constexpr int kChunksAtOnce = 64;              // bounds the memory that compressed chunks take
constexpr std::size_t kValueBytes = 4;

using Bytes = std::vector<std::uint8_t>;

/// Planes of ny x nx cells of `cell` values, cut into chunks of one plane each.
struct Grid {
  std::uint64_t planes = 1, ny = 0, nx = 0, cell = 1;
  std::uint64_t chunk_ny = 0, chunk_nx = 0;
  bool empty() const { return planes == 0 || ny == 0 || nx == 0 || cell == 0; }
  std::uint64_t down() const { return (ny + chunk_ny - 1) / chunk_ny; }
  std::uint64_t across() const { return (nx + chunk_nx - 1) / chunk_nx; }
  std::uint64_t count() const { return empty() ? 0 : planes * down() * across(); }
};

/// Where a chunk begins.
struct ChunkPlace {
  std::uint64_t plane = 0, y = 0, x = 0;
};

/// `chunk_side`: as in RowSource.
Grid grid_of(const std::vector<std::uint64_t>& shape, std::uint64_t chunk_side) {
  Grid grid;
  if (shape.size() == 3) {
    grid.ny = shape[0];
    grid.nx = shape[1];
    grid.cell = shape[2];
  } else {
    grid.ny = shape[shape.size() - 2];
    grid.nx = shape.back();
    for (std::size_t i = 0; i + 2 < shape.size(); ++i) grid.planes *= shape[i];
  }
  if (grid.empty()) return grid;
  grid.chunk_nx = chunk_side > 0 ? std::min(grid.nx, chunk_side) : grid.nx;
  const std::uint64_t rows = chunk_side > 0
                                 ? chunk_side
                                 : std::max<std::uint64_t>(1, kChunkValues / (grid.nx * grid.cell));
  grid.chunk_ny = std::min(grid.ny, rows);
  return grid;
}

std::vector<hsize_t> chunk_of(const Grid& grid, std::size_t rank) {
  if (rank == 3) return {grid.chunk_ny, grid.chunk_nx, grid.cell};
  if (rank == 2) return {grid.chunk_ny, grid.chunk_nx};
  return {1, 1, grid.chunk_ny, grid.chunk_nx};
}

ChunkPlace place_of(const Grid& grid, std::uint64_t chunk) {
  return {chunk / (grid.across() * grid.down()),
          chunk / grid.across() % grid.down() * grid.chunk_ny,
          chunk % grid.across() * grid.chunk_nx};
}

std::vector<hsize_t> chunk_offset(const ChunkPlace& at, const std::vector<std::uint64_t>& shape) {
  if (shape.size() == 3) return {at.y, at.x, 0};
  if (shape.size() == 2) return {at.y, at.x};
  return {at.plane / shape[1], at.plane % shape[1], at.y, at.x};
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

/// The chunk's values, compressed; empty for a chunk of zero bits. Chunks at the right and lower
/// edge are as large as the others, zeros beyond the plane.
Bytes compressed_chunk(const RowSource& source, const Grid& grid, const ChunkPlace& at, int level) {
  const std::uint64_t rows = std::min(grid.chunk_ny, grid.ny - at.y);
  const std::uint64_t columns = std::min(grid.chunk_nx, grid.nx - at.x);
  const int x = static_cast<int>(at.x);
  if (source.zero &&
      source.zero({x, static_cast<int>(at.y), static_cast<int>(columns), static_cast<int>(rows)}))
    return {};
  const std::uint64_t pitch = grid.chunk_nx * grid.cell;
  std::vector<std::uint32_t> values(grid.chunk_ny * pitch);
  for (std::uint64_t y = 0; y < rows; ++y)
    source.copy(static_cast<std::int64_t>(at.plane * grid.ny + at.y + y), x,
                std::span(values).subspan(y * pitch, columns * grid.cell));
  const bool zero = std::all_of(values.begin(), values.end(), [](auto v) { return v == 0; });
  return zero ? Bytes() : zlib_stream(shuffled(values), level);
}

Handle creation_list(const Grid& grid, std::size_t rank, int level) {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list.id(), false);  // equal states give equal bytes
  if (grid.empty()) return list;
  H5Pset_chunk(list.id(), static_cast<int>(rank), chunk_of(grid, rank).data());
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
      for (int i = begin; i < end && unless_interrupted(source.cancelled); ++i)
        bytes[static_cast<std::size_t>(i)] = compressed_chunk(
            source, grid, place_of(grid, static_cast<std::uint64_t>(first + i)), level);
    });
    if (!unless_interrupted(source.cancelled)) return false;
    for (int i = 0; i < n; ++i) {
      const Bytes& chunk = bytes[static_cast<std::size_t>(i)];
      if (chunk.empty()) continue;
      const std::vector<hsize_t> offset =
          chunk_offset(place_of(grid, static_cast<std::uint64_t>(first + i)), source.shape);
      if (H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, offset.data(), chunk.size(), chunk.data()) < 0)
        return false;
    }
  }
  return true;
}

}  // namespace

std::vector<hsize_t> chunk_shape(const std::vector<std::uint64_t>& shape,
                                 std::uint64_t chunk_side) {
  return chunk_of(grid_of(shape, chunk_side), shape.size());
}

hid_t write_chunked(hid_t file, const std::string& name, hid_t type, const RowSource& source,
                    int deflate_level, const Threads& threads) {
  PENTIMENTO_CHECK(source.shape.size() >= 2 && source.shape.size() <= 4);
  const Grid grid = grid_of(source.shape, source.chunk_side);
  const std::vector<hsize_t> shape(source.shape.begin(), source.shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose);
  const Handle list = creation_list(grid, shape.size(), deflate_level);
  Handle dataset(
      H5Dcreate2(file, name.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
      H5Dclose);
  if (!dataset.ok()) return dataset.release();
  if (!write_chunks(dataset.id(), source, grid, deflate_level, threads)) return -1;
  return dataset.release();
}

}  // namespace pentimento::hdf5
