#include "formats/io/file_place.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

class FilePlaceTest : public testing::Test {
 protected:
  FilePlaceTest() {
    std::filesystem::create_directory(path("folder"));
    test::spill(path("file"), "bytes");
  }
  std::string path(const std::string& name) const { return scratch_.path(name); }
  void link(const std::string& to, const std::string& name) const {
    std::filesystem::create_symlink(to, path(name));
  }
  test::Scratch scratch_;
};

TEST_F(FilePlaceTest, IsOneForAllNamesOfAFile) {
  link("file", "link");
  link("link", "folder/../far");
  std::filesystem::create_hard_link(path("file"), path("hard"));
  for (const char* name : {"link", "far", "hard", "folder/../file"})
    EXPECT_EQ(place_of(path(name)), place_of(path("file"))) << name;
  test::spill(path("other"), "bytes");
  EXPECT_NE(place_of(path("other")), place_of(path("file")));
}

TEST_F(FilePlaceTest, IsOneForAllNamesOfAFileThatIsNotThereYet) {
  link("folder/new", "link");
  link("../link", "folder/back");
  const auto place = place_of(path("folder/new"));
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->name, "new");
  for (const char* name : {"link", "folder/back", "folder/../folder/new"})
    EXPECT_EQ(place_of(path(name)), place) << name;
  EXPECT_NE(place_of(path("new")), place);
}

TEST_F(FilePlaceTest, IsNothingForWhatIsNoFile) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const char* name : {"folder", "pipe", "missing/file"})
    EXPECT_FALSE(place_of(path(name)).has_value()) << name;
  EXPECT_FALSE(place_of("/dev/null").has_value());
}

TEST_F(FilePlaceTest, OfADescriptorIsThatOfItsFile) {
  std::FILE* file = std::fopen(path("file").c_str(), "r");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(place_of_descriptor(::fileno(file)), place_of(path("file")));
  std::fclose(file);
  EXPECT_FALSE(place_of_descriptor(-1).has_value());
}

TEST_F(FilePlaceTest, FollowsLinksToTheEndButNotInACircle) {
  link("folder/new", "link");
  link("b", "a");
  link("a", "b");
  EXPECT_EQ(follow_links(path("link")), path("folder/new"));
  EXPECT_EQ(follow_links(path("file")), path("file"));
  EXPECT_EQ(follow_links(path("a")), path("a"));
}

}  // namespace
}  // namespace pentimento
