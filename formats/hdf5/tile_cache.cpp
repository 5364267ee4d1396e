#include "formats/hdf5/tile_cache.h"

#include <algorithm>
#include <utility>

namespace pentimento::hdf5 {

namespace {
std::size_t bytes_of(const KeptTile& tile) {
  return tile->size() * sizeof(std::uint32_t);
}
}  // namespace

/// The caller holds the mutex, shared or not.
KeptTile TileCache::use(CachedTile& entry) const {
  // Threads that read the same tile do not take its cache line from one another for nothing.
  if (entry.used.load(std::memory_order_relaxed) != loads_)
    entry.used.store(loads_, std::memory_order_relaxed);
  return entry.tile;
}

KeptTile TileCache::find(std::uint64_t key) const {
  const std::shared_lock<std::shared_mutex> lock(mutex_);
  const auto found = tiles_.find(key);
  return found != tiles_.end() ? use(found->second) : nullptr;
}

KeptTile TileCache::begin(std::uint64_t key) {
  std::unique_lock<std::shared_mutex> lock(mutex_);
  for (auto found = tiles_.find(key); found != tiles_.end(); found = tiles_.find(key)) {
    if (found->second.tile) return use(found->second);
    loaded_.wait(lock);
  }
  tiles_.try_emplace(key);
  return nullptr;
}

void TileCache::keep(std::uint64_t key, const KeptTile& tile) {
  const std::unique_lock<std::shared_mutex> lock(mutex_);
  make_room(bytes_of(tile));
  held_bytes_ += bytes_of(tile);
  CachedTile& entry = tiles_.at(key);
  entry.tile = tile;
  entry.used = ++loads_;
  loaded_.notify_all();
}

void TileCache::forget(std::uint64_t key) {
  const std::unique_lock<std::shared_mutex> lock(mutex_);
  tiles_.erase(key);
  loaded_.notify_all();
}

/// Unless `bytes` more fit, drops tiles until an eighth of the room is free, those first that were
/// not used for longest. The caller holds the mutex.
void TileCache::make_room(std::size_t bytes) {
  if (held_bytes_ + bytes <= most_bytes_) return;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> by_age;  // when it was used, key
  for (const auto& [key, entry] : tiles_)
    if (entry.tile) by_age.emplace_back(entry.used.load(), key);
  std::sort(by_age.begin(), by_age.end());
  for (const auto& [used, key] : by_age) {
    if (held_bytes_ + bytes <= most_bytes_ - most_bytes_ / 8) break;
    const auto oldest = tiles_.find(key);
    held_bytes_ -= bytes_of(oldest->second.tile);
    tiles_.erase(oldest);
  }
}

}  // namespace pentimento::hdf5
