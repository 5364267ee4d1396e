// The size of a TIFF before its library sees it, and that the library is not heard.

#include "formats/image/tiff_header.h"

#include <gtest/gtest.h>

#include "tests/formats/image/by_opencv.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

struct TiffEntry {
  unsigned tag, type, count, value;
};

/// A directory right behind the header, numbers in the order of bytes of `mark` ("II" or "MM").
std::string tiff_of(const std::string& mark, const std::vector<TiffEntry>& entries) {
  std::string out = mark;
  const bool big = mark == "MM";
  const auto number = [&](unsigned value, int bytes) {
    for (int i = 0; i < bytes; ++i)
      out.push_back(static_cast<char>(value >> (8 * (big ? bytes - 1 - i : i))));
  };
  number(42, 2);
  number(8, 4);
  number(static_cast<unsigned>(entries.size()), 2);
  for (const TiffEntry& e : entries) {
    number(e.tag, 2);
    number(e.type, 2);
    number(e.count, 4);
    // A short value stands at the beginning of its four bytes.
    number(e.value, e.type == 3 ? 2 : 4);
    if (e.type == 3) number(0, 2);
  }
  number(0, 4);
  return out;
}

class TiffHeader : public testing::Test {
 protected:
  Result<void> check(const std::string& bytes) {
    test::spill(path_, bytes);
    return image::check_tiff_header(path_, {});
  }
  std::string problem(const std::string& bytes) {
    const Result<void> fine = check(bytes);
    return fine ? "" : fine.error().message.substr(path_.size() + 2);
  }

  const test::Scratch scratch_;
  const std::string path_ = scratch_.path("a.tif");
};

TEST_F(TiffHeader, SizesOfBothOrdersOfBytesAndBothTypesAreSeen) {
  for (const char* mark : {"II", "MM"}) {
    EXPECT_TRUE(check(tiff_of(mark, {{256, 3, 1, 20}, {257, 4, 1, 65536}})));
    EXPECT_EQ(problem(tiff_of(mark, {{256, 3, 1, 20}, {257, 4, 1, 65537}})),
              "20 x 65537 pixels, the limit is 65536 a side");
    EXPECT_EQ(problem(tiff_of(mark, {{256, 3, 1, 20000}, {257, 3, 1, 20000}})),
              "20000 x 20000 pixels, the limit is 134217728 in all");
  }
}

TEST_F(TiffHeader, TheLargestOfSeveralSizesCounts) {
  EXPECT_EQ(problem(tiff_of("II", {{256, 3, 1, 1}, {257, 3, 1, 1}, {256, 4, 1, 70000}})),
            "70000 x 1 pixels, the limit is 65536 a side");
  EXPECT_EQ(problem(tiff_of("II", {{256, 4, 1, 70000}, {257, 3, 1, 1}, {256, 3, 1, 1}})),
            "70000 x 1 pixels, the limit is 65536 a side");
}

TEST_F(TiffHeader, SaysWhatIsBroken) {
  EXPECT_EQ(problem("II*"), "the header is not whole");
  EXPECT_EQ(problem(std::string("II*\0\xFF\0\0\0", 8)), "the first directory lies beyond the end");
  const std::string sound = tiff_of("II", {{256, 3, 1, 20}, {257, 3, 1, 20}});
  EXPECT_EQ(problem(sound.substr(0, 30)), "the first directory is not whole");
  EXPECT_EQ(problem(tiff_of("II", {{256, 3, 1, 20}})), "20 x 0 pixels");
  EXPECT_EQ(problem(tiff_of("II", {{256, 16, 1, 20}, {257, 3, 1, 20}})),
            "its size is not a number of 16 or 32 bits");
}

// OpenCV prints lines of its own about such files.
TEST_F(TiffHeader, ABrokenTiffIsOneLine) {
  const std::string sound =
      test::slurp(std::string(PENTIMENTO_SOURCE_DIR) + "/tests/fuzz/corpus/picture/small.tiff");
  ASSERT_FALSE(sound.empty());
  for (std::size_t n = 4; n < sound.size(); n += 3) {
    test::spill(path_, sound.substr(0, n));
    test::quiet_problem(path_);
  }
  for (std::size_t at = 4; at < sound.size(); ++at) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
    test::spill(path_, damaged);
    test::quiet_problem(path_);
  }
}

}  // namespace
}  // namespace pentimento
