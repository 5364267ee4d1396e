#include "replay/estimate/disk_check.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(DiskCheck, WhatFitsIsLet_WhatDoesNotIsRefused) {
  const test::Scratch scratch;
  const std::string folder = scratch.path("");
  const auto room = static_cast<double>(free_bytes(folder));
  EXPECT_GT(room, 0);
  EXPECT_TRUE(check_disk({{folder, 0.5 * room}}));
  const Result<void> over = check_disk({{folder, 2 * room}});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::kLimit);
  EXPECT_EQ(over.error().message.find(folder), 0u);
}

TEST(DiskCheck, WhatLiesOnOneDiskIsAdded) {
  const test::Scratch scratch, other;
  const auto room = static_cast<double>(free_bytes(scratch.path("")));
  EXPECT_FALSE(check_disk({{scratch.path(""), 0.7 * room}, {other.path(""), 0.7 * room}}));
}

TEST(DiskCheck, AFolderThatIsMissingIsNotJudgedHere) {
  EXPECT_TRUE(check_disk({{"/nowhere/at/all", 1e30}}));
}

}  // namespace
}  // namespace pentimento
