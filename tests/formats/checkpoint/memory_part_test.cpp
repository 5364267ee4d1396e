#include "formats/checkpoint/memory_part.h"

#include <gtest/gtest.h>

namespace pentimento::checkpoint {
namespace {

SimulationMemory some_memory() {
  SimulationMemory memory;
  memory.touches = {{0, 3, true, {true, 0.5f, 0.25f, {1, 2, 3, 4}}},
                    {2, 9, false, {false, 1, 0, {5, 6, 7, 8}}}};
  memory.account.deposited = {1e-6, {0.1, 0.2}};
  memory.account.picked_up = {2e-6, {0.3, 0.4}};
  memory.account.dried = {3e-6, {0.5, 0.6}};
  memory.stamps = 123;
  memory.fresh = true;
  memory.scheme = {1, 2, 3};
  return memory;
}

TEST(MemoryPart, BringsBackEveryValue) {
  ArchiveWriter to;
  put_memory(some_memory(), to);
  ArchiveReader from(to.bytes());
  const SimulationMemory back = take_memory(from);
  ASSERT_TRUE(from.complete()) << from.problem();
  ArchiveWriter again;
  put_memory(back, again);
  EXPECT_EQ(again.bytes(), to.bytes());
  ASSERT_EQ(back.touches.size(), 2u);
  EXPECT_EQ(back.touches[1].stroke_id, 9u);
  EXPECT_TRUE(back.touches[0].reservoir.as_loaded);
  EXPECT_EQ(back.touches[0].reservoir.dry_ahead_frac, 0.25f);
  EXPECT_EQ(back.account.picked_up.channel[1], 0.4);
  EXPECT_EQ(back.stamps, 123);
  EXPECT_TRUE(back.fresh);
}

TEST(MemoryPart, CutAnywhereIsRefused) {
  ArchiveWriter to;
  put_memory(some_memory(), to);
  for (std::size_t size = 0; size < to.bytes().size(); ++size) {
    ArchiveReader from(std::string_view(to.bytes()).substr(0, size));
    take_memory(from);
    EXPECT_FALSE(from.complete()) << size;
  }
}

}  // namespace
}  // namespace pentimento::checkpoint
