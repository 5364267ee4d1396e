#include "replay/hashes/field_hashes.h"

#include <xxhash.h>

#include <utility>

#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento {

namespace {
using conservative::SleepTiles;

constexpr std::size_t kBase = 3, kReflectance = 4;  // in kHashedFields

/// Adds the cells of `box` to a hash.
template <typename T>
std::uint64_t add(std::uint64_t hash, const Field<T>& plane, const CellBox& box) {
  const std::size_t bytes = static_cast<std::size_t>(box.width()) * sizeof(T);
  for (int y = box.y0; y < box.y1; ++y)
    hash = XXH3_64bits_withSeed(plane.view().row(y) + box.x0, bytes, hash);
  return hash;
}

std::uint64_t add(std::uint64_t hash, const GroundPlane& plane, const CellBox& box) {
  std::vector<float> row(static_cast<std::size_t>(box.width()));
  for (int y = box.y0; y < box.y1; ++y) {
    plane.read(box.x0, y, row);
    hash = XXH3_64bits_withSeed(row.data(), row.size() * sizeof(float), hash);
  }
  return hash;
}

template <typename Plane>
std::uint64_t add(std::uint64_t hash, const std::vector<Plane>& planes, const CellBox& box) {
  for (const Plane& plane : planes) hash = add(hash, plane, box);
  return hash;
}

/// Of the values of CanvasState::sleep that belong to a tile, if there are any.
std::uint64_t hash_of_sleep(const CanvasState& state, int tile) {
  const std::size_t at = static_cast<std::size_t>(tile) * conservative::kSleepValues;
  if (at + conservative::kSleepValues > state.sleep.size()) return 0;
  return XXH3_64bits_withSeed(state.sleep.data() + at, conservative::kSleepValues * sizeof(float),
                              static_cast<std::uint64_t>(tile) + 1);
}

/// In the order of kHashedFields. What lies under the wet paint changes only with the whole canvas;
/// otherwise its hashes are those `before`.
FieldHashArray hash_of(const CanvasState& state, const CellBox& box, int tile,
                       const FieldHashArray* before) {
  const std::uint64_t seed = static_cast<std::uint64_t>(tile) + 1;
  return {add(seed, state.depth_m, box),
          add(seed, state.velocity_x_m_s, box),
          add(seed, state.velocity_y_m_s, box),
          before != nullptr ? (*before)[kBase] : add(seed, state.base_m, box),
          before != nullptr ? (*before)[kReflectance] : add(seed, state.reflectance, box),
          add(seed, state.pigment, box),
          add(seed, state.stroke, box),
          hash_of_sleep(state, tile)};
}

bool is_awake(const CanvasState& state, int tile) {
  const std::size_t at = static_cast<std::size_t>(tile) * conservative::kSleepValues +
                         static_cast<std::size_t>(conservative::kAsleep);
  return at >= state.sleep.size() || state.sleep[at] == 0;
}
}  // namespace

FieldHashes::FieldHashes(const CanvasGeometry& geometry, float sleep_tile_m) : geometry_(geometry) {
  const SleepTiles tiles(geometry, sleep_tile_m);
  columns_ = tiles.columns();
  rows_ = tiles.rows();
  tile_width_ = tiles.tile_width();
  tile_height_ = tiles.tile_height();
  tiles_.resize(static_cast<std::size_t>(tiles.count()));
  was_awake_.assign(tiles_.size(), 1);
}

CellBox FieldHashes::box(int tile) const {
  const int x0 = tile % columns_ * tile_width_, y0 = tile / columns_ * tile_height_;
  return {x0, std::min(x0 + tile_width_, geometry_.width), y0,
          std::min(y0 + tile_height_, geometry_.height)};
}

bool FieldHashes::may_have_changed(const CanvasState& state, int tile) const {
  const std::size_t t = static_cast<std::size_t>(tile);
  return was_awake_[t] != 0 || is_awake(state, tile) ||
         tiles_[t].back() != hash_of_sleep(state, tile);
}

void FieldHashes::update(const CanvasState& state, const Threads& threads, bool all) {
  const int count = columns_ * rows_;
  all = std::exchange(is_first_, false) || all;
  std::vector<int> looked_at;
  for (int tile = 0; tile < count; ++tile)
    if (all || may_have_changed(state, tile)) looked_at.push_back(tile);
  std::vector<FieldHashArray> now(looked_at.size());
  threads.for_ranges(0, static_cast<int>(looked_at.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const int tile = looked_at[static_cast<std::size_t>(i)];
      now[static_cast<std::size_t>(i)] =
          hash_of(state, box(tile), tile, all ? nullptr : &tiles_[static_cast<std::size_t>(tile)]);
    }
  });
  changed_.clear();
  for (std::size_t i = 0; i < looked_at.size(); ++i) {
    const std::size_t tile = static_cast<std::size_t>(looked_at[i]);
    was_awake_[tile] = is_awake(state, looked_at[i]) ? 1 : 0;
    if (now[i] == tiles_[tile]) continue;
    for (std::size_t f = 0; f < fields_.size(); ++f) fields_[f] ^= tiles_[tile][f] ^ now[i][f];
    tiles_[tile] = now[i];
    changed_.push_back({looked_at[i], static_cast<std::uint32_t>(
                                          XXH3_64bits(now[i].data(), sizeof(FieldHashArray)))});
  }
}

}  // namespace pentimento
