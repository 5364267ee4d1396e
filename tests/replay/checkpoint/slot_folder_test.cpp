#include "replay/checkpoint/slot_folder.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;

TEST(SlotFolder, KnowsItsFilesAndLeavesOthersAlone) {
  const Scratch scratch;
  const std::string path = scratch.path("ck");
  const auto folder = SlotFolder::open(path);
  ASSERT_TRUE(folder) << folder.error().message;
  EXPECT_EQ((*folder)->next_generation(), 1u);
  for (const char* name : {"3.slot", "9.slot", "10.slot", "11.slot.part", "9.planes", "2.planes",
                           "0.output", "1.frames", "notes.txt", "x3.slot", "3.slots"})
    test::spill(path + "/" + name, "x");
  EXPECT_EQ((*folder)->slots(), (std::vector<std::uint64_t>{10, 9, 3}));
  EXPECT_EQ((*folder)->next_generation(), 12u);
  (*folder)->keep_only({9, 10}, {9});
  EXPECT_EQ((*folder)->slots(), (std::vector<std::uint64_t>{10, 9}));
  EXPECT_FALSE(std::filesystem::exists(path + "/2.planes"));
  EXPECT_FALSE(std::filesystem::exists(path + "/11.slot.part"));
  EXPECT_TRUE(std::filesystem::exists(path + "/0.output"));
  (*folder)->clear();
  std::size_t left = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path)) ++left;
  EXPECT_EQ(left, 3u) << "notes.txt, x3.slot, 3.slots";
}

TEST(SlotFolder, GoesAwayIfNothingElseIsInIt) {
  const Scratch scratch;
  const auto folder = SlotFolder::open(scratch.path("ck"));
  ASSERT_TRUE(folder);
  test::spill(scratch.path("ck/1.slot"), "x");
  (*folder)->clear();
  EXPECT_FALSE(std::filesystem::exists(scratch.path("ck")));
}

TEST(SlotFolder, SaysWhyItCannotBeUsed) {
  const Scratch scratch;
  EXPECT_EQ(SlotFolder::open(scratch.path("no/ck")).error().code, ErrorCode::kIo);
  test::spill(scratch.path("file"), "x");
  EXPECT_EQ(SlotFolder::open(scratch.path("file")).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
