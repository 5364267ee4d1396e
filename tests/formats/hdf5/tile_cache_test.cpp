#include "formats/hdf5/tile_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>

namespace pentimento::hdf5 {
namespace {

KeptTile tile_of(std::size_t values, std::uint32_t value) {
  return std::make_shared<const TileValues>(values, value);
}

TEST(TileCache, LoadsATileOnceForAllThreads) {
  TileCache cache(1000);
  std::atomic<int> loads{0}, asking{0}, right{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      ++asking;
      const KeptTile tile = cache.get(7, [&] {
        // Until the others ask too: they must wait, and not load it again.
        while (asking < 4) std::this_thread::yield();
        ++loads;
        return tile_of(3, 5);
      });
      if (tile && *tile == TileValues(3, 5)) ++right;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(loads, 1);
  EXPECT_EQ(right, 4);
}

TEST(TileCache, DropsThoseThatWereNotUsedForLongest) {
  TileCache cache(4 * 100);  // ten tiles of ten values
  for (std::uint64_t key = 0; key < 10; ++key) cache.get(key, [&] { return tile_of(10, 1); });
  EXPECT_TRUE(cache.find(0));
  // The eleventh needs room, and an eighth of all is to be free after it: three go. The oldest was
  // just used.
  cache.get(10, [&] { return tile_of(10, 1); });
  for (std::uint64_t key = 0; key <= 10; ++key)
    EXPECT_EQ(cache.find(key) != nullptr, key == 0 || key > 3) << key;
}

TEST(TileCache, ADroppedTileStaysWithWhoHasIt) {
  TileCache cache(4 * 10);
  const KeptTile held = cache.get(0, [&] { return tile_of(10, 8); });
  for (std::uint64_t key = 1; key < 5; ++key) cache.get(key, [&] { return tile_of(10, 1); });
  EXPECT_FALSE(cache.find(0));
  EXPECT_EQ(*held, TileValues(10, 8));
}

TEST(TileCache, ALoadThatFailsIsTriedAgain) {
  TileCache cache(1000);
  EXPECT_THROW(cache.get(7, []() -> KeptTile { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_FALSE(cache.find(7));
  EXPECT_EQ(*cache.get(7, [] { return tile_of(1, 2); }), TileValues(1, 2));
}

}  // namespace
}  // namespace pentimento::hdf5
