#pragma once
// Tiles of 4-byte values that were read from a file, those that were used last. For this folder
// only.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

namespace pentimento::hdf5 {

/// The values of a tile.
using TileValues = std::vector<std::uint32_t>;
using KeptTile = std::shared_ptr<const TileValues>;

/// Every function may be called from several threads at once.
class TileCache {
 public:
  /// Keeps up to about `most_bytes` of values.
  explicit TileCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  std::size_t most_bytes() const { return most_bytes_; }
  /// nullptr if the tile is not kept, or not yet.
  KeptTile find(std::uint64_t key) const;

  /// The tile. If it is not kept, one thread calls load(), and all others that ask for it wait.
  /// What load() throws comes out of one call; the next one tries again.
  template <typename Load>
  KeptTile get(std::uint64_t key, const Load& load) {
    if (KeptTile kept = find(key)) return kept;
    if (KeptTile made_by_other = begin(key)) return made_by_other;
    UnfinishedTile unfinished{*this, key};
    KeptTile tile = load();
    unfinished.finish(tile);
    return tile;
  }

 private:
  struct CachedTile {
    KeptTile tile;  // nullptr while a thread loads it
    std::atomic<std::uint64_t> used{0};
  };
  /// A tile that is being loaded; it is forgotten unless finish() is called.
  struct UnfinishedTile {
    TileCache& cache;
    std::uint64_t key;
    bool finished = false;
    void finish(const KeptTile& tile) {
      cache.keep(key, tile);
      finished = true;
    }
    ~UnfinishedTile() {
      if (!finished) cache.forget(key);
    }
  };

  /// Notes that the caller loads the tile, and returns nullptr; or the tile that another loaded.
  KeptTile begin(std::uint64_t key);
  void keep(std::uint64_t key, const KeptTile& tile);
  void forget(std::uint64_t key);
  KeptTile use(CachedTile& entry) const;
  void make_room(std::size_t bytes);

  std::size_t most_bytes_;
  mutable std::shared_mutex mutex_;  // of what follows
  std::condition_variable_any loaded_;
  mutable std::unordered_map<std::uint64_t, CachedTile> tiles_;
  std::uint64_t loads_ = 0;  // the clock of CachedTile::used
  std::size_t held_bytes_ = 0;
};

}  // namespace pentimento::hdf5
