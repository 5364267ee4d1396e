#include "core/canvas/tile_store.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace pentimento {
namespace {

constexpr std::size_t kFloats = 128 * 128;
constexpr std::int64_t kBlockBytes = kFloats * 4;

std::unique_ptr<TileStore> open_store(const std::string& scratch, std::int64_t budget = 0) {
  auto store = TileStore::open({kFloats, scratch, budget});
  EXPECT_TRUE(store) << store.error().message;
  return store ? std::move(*store) : nullptr;
}

std::string folder() {
  return std::filesystem::temp_directory_path().string();
}

bool all_are(const TileStore& store, TileStore::Buffer buffer, float value) {
  const float* data = store.data(buffer);
  return std::all_of(data, data + kFloats, [&](float v) { return v == value; });
}

/// Pages of files that the process has in memory, bytes. What it has besides, such as the shadow
/// that the address sanitizer keeps of each page touched, is not the store's.
std::int64_t resident_of_files() {
  std::ifstream file("/proc/self/statm");
  std::int64_t all = 0, resident = 0, of_files = 0;
  file >> all >> resident >> of_files;
  return of_files * sysconf(_SC_PAGESIZE);
}

TEST(TileStore, GivesZerosInMemoryAndInAFile) {
  for (const std::string& scratch : {std::string(), folder()}) {
    const auto store = open_store(scratch);
    const TileStore::Buffer a = *store->allocate(), b = *store->allocate();
    EXPECT_TRUE(all_are(*store, a, 0));
    std::fill_n(store->data(a), kFloats, 1.0f);
    std::fill_n(store->data(b), kFloats, 2.0f);
    EXPECT_TRUE(all_are(*store, a, 1));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(store->data(b)) % 64, 0u);
    store->free(a);
    EXPECT_EQ(store->bytes(), kBlockBytes);
    const TileStore::Buffer again = *store->allocate();
    EXPECT_EQ(again, a);
    EXPECT_TRUE(all_are(*store, again, 0));
    EXPECT_TRUE(all_are(*store, b, 2));
  }
}

/// Pages of a buffer that the process has in memory.
std::ptrdiff_t pages_in_memory(const TileStore& store, TileStore::Buffer buffer) {
  std::array<unsigned char, 64> in_memory{};
  EXPECT_EQ(mincore(store.data(buffer), kBlockBytes, in_memory.data()), 0);
  return std::count_if(in_memory.begin(), in_memory.end(), [](auto page) { return page & 1; });
}

TEST(TileStore, GivesABufferAllItsMemoryWhenAsked) {
  const std::int64_t pages = kBlockBytes / sysconf(_SC_PAGESIZE);
  const auto store = open_store({});
  const TileStore::Buffer a = *store->allocate();
  if (madvise(store->data(a), kBlockBytes, MADV_POPULATE_WRITE) != 0)
    GTEST_SKIP() << "this system gives pages one by one";
  const TileStore::Buffer b = *store->allocate();
  EXPECT_EQ(pages_in_memory(*store, b), 0);
  store->give_memory(b);
  EXPECT_EQ(pages_in_memory(*store, b), pages);
  EXPECT_TRUE(all_are(*store, b, 0));
  store->free(b);
  EXPECT_EQ(pages_in_memory(*store, b), 0);
}

TEST(TileStore, LeavesNoFileBehind) {
  const std::filesystem::path own = std::filesystem::path(folder()) / "pentimento_tile_store_test";
  std::filesystem::create_directory(own);
  const auto store = open_store(own.string());
  ASSERT_TRUE(store->allocate());
  EXPECT_TRUE(std::filesystem::is_empty(own));
  std::filesystem::remove(own);
}

TEST(TileStore, TrimsWhatWasTouchedLongestAgoAndKeepsItsValues) {
  constexpr int kBlocks = 2000;  // 131 MB: two segments
  const auto store = open_store(folder(), 500 * kBlockBytes);
  const std::int64_t before = resident_of_files();
  for (int i = 0; i < kBlocks; ++i) {
    const auto buffer = store->allocate();
    ASSERT_TRUE(buffer) << buffer.error().message;
    std::fill_n(store->data(*buffer), kFloats, static_cast<float>(i));
    if (i % 100 == 99) store->trim();
  }
  EXPECT_EQ(store->held_bytes(), 500 * kBlockBytes);
  // What the kernel counts must follow: within a tenth, and 4 MB that the process took besides.
  EXPECT_LT(resident_of_files() - before, 550 * kBlockBytes + 4'000'000);
  store->mark_used(0);
  store->trim();
  EXPECT_EQ(store->held_bytes(), 500 * kBlockBytes);
  for (int i = 0; i < kBlocks; ++i)
    EXPECT_TRUE(all_are(*store, static_cast<TileStore::Buffer>(i), static_cast<float>(i))) << i;
}

TEST(TileStore, ServesSeveralThreads) {
  const auto store = open_store(folder(), 64 * kBlockBytes);
  std::vector<std::thread> threads;
  std::array<bool, 4> right{};
  for (std::size_t t = 0; t < right.size(); ++t) {
    threads.emplace_back([&, t] {
      bool good = true;
      for (int i = 0; i < 200; ++i) {
        const TileStore::Buffer buffer = *store->allocate();
        good = good && all_are(*store, buffer, 0);
        std::fill_n(store->data(buffer), kFloats, static_cast<float>(t + 1));
        good = good && all_are(*store, buffer, static_cast<float>(t + 1));
        if (i % 2 == 0) store->free(buffer);
      }
      right[t] = good;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, (std::array<bool, 4>{true, true, true, true}));
  EXPECT_EQ(store->buffers(), 400);
}

TEST(TileStore, TellsThatTheDiskIsFull) {
  // A limit on the size of files stands for the end of the disk: the same error path.
  const auto store = open_store(folder());
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  rlimit low = old;
  low.rlim_cur = 100'000'000;
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &low), 0);
  bool refused = false;
  for (int i = 0; i < 4000 && !refused; ++i) {
    const auto buffer = store->allocate();
    refused = !buffer;
    if (refused) {
      EXPECT_EQ(buffer.error().code, ErrorCode::kIo);
      EXPECT_EQ(buffer.error().message.find("--scratch " + folder()), 0u) << buffer.error().message;
    } else {
      *store->data(*buffer) = 1;
    }
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_TRUE(refused);
  EXPECT_GT(store->buffers(), 900);  // the first segment of 64 MiB has 1024
}

TEST(TileStore, NeedsAFolderThatTakesFiles) {
  const auto store = TileStore::open({kFloats, "/nowhere/at/all", 0});
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
