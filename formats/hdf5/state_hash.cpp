#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cstring>

#include "formats/hdf5/layout.h"
#include "formats/hdf5/sleep.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/sha256.h"

namespace pentimento {

namespace {

/// The hash is of little-endian values.
void to_little_endian(std::span<std::uint32_t> values) {
  if constexpr (std::endian::native == std::endian::big)
    for (std::uint32_t& v : values) v = __builtin_bswap32(v);
}

void add_sleep(const CanvasState& state, Sha256& hash) {
  const std::vector<float> sleep = hdf5::sleep_to_dump(state);
  hash.update(fmt::format("{} float32 {}\n", hdf5::kSleepName,
                          fmt::join(hdf5::sleep_shape(sleep.size()), " ")));
  std::vector<std::uint32_t> bits(sleep.size());
  std::memcpy(bits.data(), sleep.data(), sleep.size() * sizeof(float));
  to_little_endian(bits);
  hash.update(bits.data(), bits.size() * sizeof(std::uint32_t));
}

void add_planes(const CanvasSource& canvas, Sha256& hash) {
  hash.update(fmt::format("{} {}\nstep {}\n", kStateFormat, kHashVersion, canvas.step()));
  const hdf5::CanvasShape shape = hdf5::shape_of(canvas);
  std::vector<std::uint32_t> row;
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    if (dataset.is_derived) continue;
    hash.update(fmt::format("{} {} {}\n", dataset.name, dataset.is_integer ? "uint32" : "float32",
                            fmt::join(hdf5::shape_of(shape, dataset), " ")));
    row.resize(static_cast<std::size_t>(canvas.geometry().width) *
               static_cast<std::size_t>(hdf5::cell_values(shape, dataset)));
    for (std::int64_t y = 0; y < hdf5::row_count(canvas, dataset); ++y) {
      hdf5::copy_cells(canvas, dataset, y, 0, row);
      to_little_endian(row);
      hash.update(row.data(), row.size() * sizeof(std::uint32_t));
    }
  }
}

}  // namespace

std::string state_sha256(const CanvasState& state) {
  Sha256 hash;
  add_planes(StateSource(state), hash);
  if (!state.sleep.empty()) add_sleep(state, hash);
  return hash.hex();
}

std::string state_sha256(const CanvasSource& canvas) {
  Sha256 hash;
  add_planes(canvas, hash);
  return hash.hex();
}

}  // namespace pentimento
