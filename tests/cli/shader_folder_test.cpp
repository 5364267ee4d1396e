#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

namespace fs = std::filesystem;

std::size_t files_below(const std::string& folder) {
  std::size_t count = 0;
  if (!fs::is_directory(folder)) return count;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.is_regular_file() ? 1 : 0;
  return count;
}

/// The picture of the small painting, rendered with these variables set.
std::string picture(const Workplace& place, const std::string& variables) {
  const Ran ran = place.run("render a.jsonl -o a.png --quiet",
                            "env " + variables + " MESA_SHADER_CACHE_DISABLE=true");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  return place.read("a.png");
}

TEST(ShaderFolder, IsMadeForThisUserAloneAndChangesNoPixel) {
  const Workplace place;
  const std::string without = picture(place, "PENTIMENTO_CACHE=");
  const std::string kept = picture(place, "PENTIMENTO_CACHE=kept");
  const std::size_t files = files_below(place.path("kept"));
  EXPECT_GT(files, 0u);
  struct stat found {};
  ASSERT_EQ(::lstat(place.path("kept").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777, 0700u);
  const std::string again = picture(place, "PENTIMENTO_CACHE=kept");
  // Mesa writes from a thread, which the end of a run may overtake: the next run writes the rest.
  EXPECT_GE(files_below(place.path("kept")), files);
  EXPECT_EQ(kept, without);
  EXPECT_EQ(again, without);
}

TEST(ShaderFolder, IsWhereTheSpecificationHasIt) {
  const Workplace place;
  const std::string here = place.path("");
  // A cache of the user's, or the one at home.
  picture(place, "-u PENTIMENTO_CACHE XDG_CACHE_HOME=" + here + "xdg HOME=" + here + "home");
  EXPECT_GT(files_below(place.path("xdg/pentimento")), 0u);
  fs::create_directory(place.path("home"));
  picture(place, "-u PENTIMENTO_CACHE XDG_CACHE_HOME=xdg HOME=" + here + "home");
  EXPECT_GT(files_below(place.path("home/.cache/pentimento")), 0u);
  // No home: nowhere, and no word about it.
  picture(place, "-u PENTIMENTO_CACHE -u XDG_CACHE_HOME HOME=" + here + "nobody");
  EXPECT_FALSE(place.has("nobody"));
  picture(place, "-u PENTIMENTO_CACHE -u XDG_CACHE_HOME -u HOME");
}

TEST(ShaderFolder, IsNoneThatOthersCanPutShadersInto) {
  const Workplace place;
  fs::create_directory(place.path("open"));
  fs::permissions(place.path("open"), fs::perms::all);
  fs::create_directory(place.path("own"));
  fs::permissions(place.path("own"), fs::perms::owner_all);
  fs::create_symlink("own", place.path("link"));
  place.run("info a.jsonl", "touch file &&");
  for (const char* folder : {"open", "link", "file", "missing/deep"}) {
    picture(place, std::string("PENTIMENTO_CACHE=") + folder);
    EXPECT_EQ(files_below(place.path(folder)), 0u) << folder;
  }
  EXPECT_EQ(files_below(place.path("own")), 0u);
  EXPECT_FALSE(place.has("missing"));
}

TEST(ShaderFolder, ServesRelight) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5 --quiet", "env PENTIMENTO_CACHE=").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o a.png --quiet", "env PENTIMENTO_CACHE=kept").code, 0);
  EXPECT_GT(files_below(place.path("kept")), 0u);
}

}  // namespace
}  // namespace pentimento::test
