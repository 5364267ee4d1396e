#include "formats/io/part_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// What a process that has ended meanwhile left behind.
std::string stale_part(const test::Scratch& scratch) {
  const std::string mine = part_name(scratch.path("picture.png"));
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  std::string name = mine;
  const std::string own = "-" + std::to_string(::getpid()) + "-";
  name.replace(name.rfind(own), own.size(), "-" + std::to_string(child) + "-");
  test::spill(name, "half a picture");
  return name;
}

TEST(PartFile, HasAShortNewNameBesideItsTarget) {
  const std::string first = part_name("folder/" + std::string(200, 'x') + ".png");
  EXPECT_TRUE(first.starts_with("folder/.pentimento-")) << first;
  EXPECT_LT(first.size(), 60U);
  EXPECT_NE(part_name("folder/a.png"), first);
  EXPECT_TRUE(part_name("a.png").starts_with("./.pentimento-"));
}

TEST(PartFile, OfADeadRunIsRemoved) {
  const test::Scratch scratch;
  const std::string stale = stale_part(scratch);
  EXPECT_EQ(remove_stale_parts(scratch.path("")), 1);
  EXPECT_FALSE(std::filesystem::exists(stale));
  EXPECT_EQ(remove_stale_parts(scratch.path("missing")), 0);
}

TEST(PartFile, OfALivingRunOfAnotherMachineOrOfAnotherProgramStays) {
  const test::Scratch scratch;
  const std::string stale = stale_part(scratch);
  std::filesystem::remove(stale);
  const std::string name = std::filesystem::path(stale).filename().string();
  std::string elsewhere = name;  // another machine, or another container
  elsewhere[std::string(".pentimento-").size()] = 'x';
  const std::string living = std::filesystem::path(part_name("a")).filename().string();
  for (const std::string& kept : {elsewhere, living, std::string("picture.part"), name + ".png",
                                  name.substr(1), std::string(".pentimento-1-2.part")})
    test::spill(scratch.path(kept), "not ours to remove");
  EXPECT_EQ(remove_stale_parts(scratch.path("")), 0);
  EXPECT_EQ(scratch.files(), 6U);
}

TEST(PartFile, ThatIsALinkOrOfAnotherUserStays) {
  const test::Scratch scratch;
  const std::string stale = stale_part(scratch);
  std::filesystem::remove(stale);
  test::spill(scratch.path("file"), "bytes");
  std::filesystem::create_symlink(scratch.path("file"), stale);
  EXPECT_EQ(remove_stale_parts(scratch.path("")), 0);
  std::filesystem::remove(stale);
  test::spill(stale, "bytes");
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  ASSERT_EQ(::chown(stale.c_str(), 12345, 12345), 0);
  EXPECT_EQ(remove_stale_parts(scratch.path("")), 0);
}

TEST(PartFile, AFolderOfADeadRunGoesWithWhatItHolds_AndFilesStay) {
  const test::Scratch scratch;
  const std::string stale = stale_part(scratch);
  EXPECT_EQ(remove_stale_part_folders(scratch.path("")), 0) << "a file is no folder";
  std::filesystem::remove(stale);
  std::filesystem::create_directories(stale + "/deeper");
  test::spill(stale + "/deeper/picture.png", "half a picture");
  const std::string living = part_name(scratch.path("a"));
  std::filesystem::create_directory(living);
  EXPECT_EQ(remove_stale_parts(scratch.path("")), 0) << "a folder is no file";
  EXPECT_EQ(remove_stale_part_folders(scratch.path("")), 1);
  EXPECT_FALSE(std::filesystem::exists(stale));
  EXPECT_TRUE(std::filesystem::exists(living));
}

}  // namespace
}  // namespace pentimento
