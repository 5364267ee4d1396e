#include "formats/hdf5/detail_checkpoint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "formats/hdf5/chunked.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/write_small.h"
#include "formats/io/sha256.h"

namespace pentimento::hdf5 {

namespace {

using Shape = std::vector<std::uint64_t>;

constexpr const char* kGroup = "/detail";
constexpr const char* kLeft = "/detail/left";
constexpr std::size_t kLeftValues = 5;  // x, y, way right, way up, 1 = in this step

/// A dataset of whole numbers.
struct Table {
  const char* name;
  const char* long_name;
  std::vector<std::uint32_t> DetailCheckpoint::*values;
  Shape shape;
};

std::vector<Table> tables_of(const CheckpointedCanvas& of) {
  const CanvasGeometry& g = of.guide.geometry;
  const auto nx = static_cast<std::uint64_t>(g.width), ny = static_cast<std::uint64_t>(g.height);
  const auto tiles = static_cast<std::uint64_t>(DetailLayout(g, of.factor).tiles());
  const auto columns =
      static_cast<std::uint64_t>(kCheckpointPigment + of.guide.layers * of.guide.channels);
  return {{"/detail/tile",
           "per tile: 1 = painted; 1 + steps since it was locked, 0 = long ago; then 1 = has "
           "reflectance, depth, pigment of each layer and channel",
           &DetailCheckpoint::tile,
           {tiles, columns}},
          {"/detail/block",
           "per cell of the guide: bits of how its layers open and what is left to do",
           &DetailCheckpoint::block,
           {ny, nx}},
          {"/detail/waiting",
           "per cell of the guide: a bit for each finer cell that waits for its layer to open",
           &DetailCheckpoint::waiting,
           {ny, nx, static_cast<std::uint64_t>(waiting_words(of.factor))}}};
}

std::vector<float> left_values(const DetailCheckpoint& checkpoint) {
  std::vector<float> values;
  for (const StampedBlock& b : checkpoint.stamped)
    for (const float v :
         {static_cast<float>(b.x), static_cast<float>(b.y), b.way.x, -b.way.y, b.now ? 1.0f : 0.0f})
      values.push_back(v);
  return values;
}

/// The hash of names, shapes and values, little-endian.
std::string hash_of(const DetailCheckpoint& checkpoint, const CheckpointedCanvas& of) {
  Sha256 hash;
  const auto add = [&](const char* name, const char* type, const Shape& shape,
                       std::vector<std::uint32_t> bits) {
    if constexpr (std::endian::native == std::endian::big)
      for (std::uint32_t& v : bits) v = __builtin_bswap32(v);
    hash.update(fmt::format("{} {} {}\n", name, type, fmt::join(shape, " ")));
    hash.update(bits.data(), bits.size() * sizeof(std::uint32_t));
  };
  for (const Table& table : tables_of(of))
    add(table.name, "uint32", table.shape, checkpoint.*table.values);
  std::vector<std::uint32_t> bits;
  for (const float v : left_values(checkpoint)) bits.push_back(std::bit_cast<std::uint32_t>(v));
  add(kLeft, "float32", {checkpoint.stamped.size(), kLeftValues}, bits);
  return hash.hex();
}

bool write_table(hid_t file, const Table& table, const std::vector<std::uint32_t>& values,
                 int deflate_level, const Threads& threads) {
  RowSource source;
  source.shape = table.shape;
  const std::size_t cell = table.shape.size() == 3 ? table.shape[2] : 1;
  const std::size_t row_values = table.shape[1] * cell;
  source.copy = [&values, cell, row_values](std::int64_t row, int x, std::span<std::uint32_t> out) {
    const std::size_t first = static_cast<std::size_t>(row) * row_values;
    std::copy_n(
        values.begin() + static_cast<std::ptrdiff_t>(first + static_cast<std::size_t>(x) * cell),
        out.size(), out.begin());
  };
  const Handle dataset(
      write_chunked(file, table.name, H5T_NATIVE_UINT32, source, deflate_level, threads), H5Dclose);
  return dataset.ok() && describe(dataset.id(), "1", table.long_name);
}

/// Blocks that the brush was over, as rows of `values`. False if one is not on the canvas.
bool restore_released(const std::vector<double>& values, const CanvasGeometry& guide,
                      DetailCheckpoint& checkpoint) {
  const auto on = [](double v, int count) { return v >= 0 && v < count && v == std::floor(v); };
  for (std::size_t i = 0; i + kLeftValues <= values.size(); i += kLeftValues) {
    const double* v = &values[i];
    if (!on(v[0], guide.width) || !on(v[1], guide.height)) return false;
    if (!(std::hypot(v[2], v[3]) <= 1.01)) return false;
    checkpoint.stamped.push_back({static_cast<int>(v[0]),
                                  static_cast<int>(v[1]),
                                  {static_cast<float>(v[2]), -static_cast<float>(v[3])},
                                  v[4] != 0});
  }
  return true;
}

/// Whether all columns but the number of steps are flags.
bool right_tiles(const DetailCheckpoint& checkpoint, std::uint64_t columns) {
  for (std::size_t i = 0; i < checkpoint.tile.size(); ++i)
    if (i % columns != kCheckpointRest && checkpoint.tile[i] > 1) return false;
  return true;
}

std::uint64_t bytes_of(const Shape& shape) {
  std::uint64_t bytes = sizeof(std::uint32_t);
  for (const std::uint64_t n : shape) bytes *= n;
  return bytes;
}

/// Whether all layers go to layers that exist.
bool right_layers(const DetailCheckpoint& checkpoint, int layers) {
  const auto right = [&](std::uint32_t bits) {
    for (int layer = 0; layer < layers; ++layer)
      if (static_cast<int>(bits >> (layer * kCheckpointLayerBits) & 7u) >= layers) return false;
    return true;
  };
  return std::all_of(checkpoint.block.begin(), checkpoint.block.end(), right);
}

}  // namespace

bool write_checkpoint(hid_t file, const DetailCheckpoint& checkpoint, const CheckpointedCanvas& of,
                      int deflate_level, const Threads& threads) {
  bool ok = make_group(file, kGroup);
  for (const Table& table : tables_of(of))
    ok = ok && write_table(file, table, checkpoint.*table.values, deflate_level, threads);
  ok = ok && write_small(file,
                         {kLeft,
                          "1",
                          "cells of the guide that the brush was over lately: column, row, way "
                          "right and up, 1 = since the last step",
                          {checkpoint.stamped.size(), kLeftValues}},
                         left_values(checkpoint));
  const Handle group(H5Gopen2(file, kGroup, H5P_DEFAULT), H5Gclose);
  return ok && set_attribute(group.id(), "sha256", std::string_view(hash_of(checkpoint, of)));
}

Result<std::optional<DetailCheckpoint>> read_checkpoint(const CanvasGroup& from,
                                                        const CheckpointedCanvas& of) {
  if (lacks(from.file, kGroup)) return std::optional<DetailCheckpoint>();
  const auto bad = [&](const std::string& what) {
    return Error{ErrorCode::kBadInput, from.path + ": " + what};
  };
  DetailCheckpoint checkpoint;
  for (const Table& table : tables_of(of)) {
    const std::string problem = dataset_problem(from.file, table.name);
    if (!problem.empty()) return bad(problem);
    // The values, and a copy while they are hashed.
    from.rehearsal.expect(bytes_of(table.shape), 2 * bytes_of(table.shape));
    if (Result<void> go = from.go_on(); !go) return go.error();
    auto values = read_words(from.file, table.name, table.shape);
    if (!values) return bad(fmt::format("{} is missing or malformed", table.name));
    checkpoint.*table.values = std::move(*values);
  }
  const CanvasGeometry& guide = of.guide.geometry;
  const auto shape = dataset_shape(from.file, kLeft);
  const std::uint64_t cells =
      static_cast<std::uint64_t>(guide.width) * static_cast<std::uint64_t>(guide.height);
  if (!shape || shape->size() != 2 || (*shape)[0] > cells || (*shape)[1] != kLeftValues)
    return bad(fmt::format("{} is missing or malformed", kLeft));
  const auto left = read_doubles(from.file, kLeft, *shape);
  if (!left || !restore_released(*left, guide, checkpoint))
    return bad(fmt::format("{} names a cell that there is not", kLeft));
  if (!right_layers(checkpoint, of.guide.layers))
    return bad("/detail/block names a layer that there is not");
  if (!right_tiles(checkpoint, tables_of(of).front().shape[1]))
    return bad("/detail/tile has a flag that is neither 0 nor 1");
  const Handle group = open_group(from.file, kGroup);
  const std::string said = text_attribute(group.id(), "sha256").value_or("nothing");
  const std::string hash = hash_of(checkpoint, of);
  if (hash != said) return bad("/detail has the hash " + hash + ", it says " + said);
  return std::optional<DetailCheckpoint>(std::move(checkpoint));
}

}  // namespace pentimento::hdf5
