#include "formats/io/temporaries.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(Temporaries, RemovesWhatIsNotedAndNothingElse) {
  const test::Scratch scratch;
  for (const char* name : {"a", "b", "c"}) test::spill(scratch.path(name), "x");
  note_temporary(scratch.path("a"));
  note_temporary(scratch.path("b"));
  forget_temporary(scratch.path("b"));
  remove_temporaries();
  EXPECT_FALSE(std::filesystem::exists(scratch.path("a")));
  EXPECT_TRUE(std::filesystem::exists(scratch.path("b")));
  EXPECT_TRUE(std::filesystem::exists(scratch.path("c")));
  forget_temporary(scratch.path("a"));
}

TEST(Temporaries, MoreThanThereIsRoomForAreLeft) {
  const test::Scratch scratch;
  for (int i = 0; i < 1000; ++i) note_temporary(scratch.path(std::to_string(i)));
  note_temporary(std::string(5000, 'x'));
  for (int i = 0; i < 1000; ++i) forget_temporary(scratch.path(std::to_string(i)));
  test::spill(scratch.path("7"), "x");
  remove_temporaries();
  EXPECT_TRUE(std::filesystem::exists(scratch.path("7")));
}

}  // namespace
}  // namespace pentimento
