#include "formats/log/edit/merge_headers.h"

#include <gtest/gtest.h>

namespace pentimento::log {
namespace {

PigmentSpec pigment(const std::string& name, double opacity = 0.7) {
  PigmentSpec out;
  out.name = name;
  out.color = Rgb{1, 0, 0};
  out.opacity = opacity;
  return out;
}
BrushSpec brush(const std::string& name, const std::string& shape) {
  BrushSpec out;
  out.name = name;
  out.shape = shape;
  return out;
}

TEST(MergeHeaders, TakesWhatItDoesNotHave) {
  Header header, other;
  header.title = "first";
  header.palette = {pigment("a"), pigment("b")};
  header.brushes = {brush("mine", "flat")};
  other.title = "second";
  other.palette = {pigment("b"), pigment("c")};
  other.brushes = {brush("mine", "flat"), brush("yours", "fan")};
  ASSERT_TRUE(merge_headers(header, other));
  EXPECT_EQ(header.title, "first");
  ASSERT_EQ(header.palette.size(), 3u);
  EXPECT_EQ(header.palette[2].name, "c");
  ASSERT_EQ(header.brushes.size(), 2u);
  EXPECT_EQ(header.brushes[1].shape, "fan");
}

TEST(MergeHeaders, KeepsTheFirstPigment) {
  Header header, other;
  other.palette = {pigment("c")};
  ASSERT_TRUE(merge_headers(header, other));
  ASSERT_EQ(header.palette.size(), 2u);
  EXPECT_EQ(header.palette[0].name, "Ivory Black");
  EXPECT_TRUE(header.palette[0].library);
  Header none, neither;
  ASSERT_TRUE(merge_headers(none, neither));
  EXPECT_TRUE(none.palette.empty());
}

TEST(MergeHeaders, RefusesWhatCannotBeOneCanvas) {
  const auto error = [](Header header, const Header& other) {
    return merge_headers(header, other).error().message;
  };
  Header other;
  other.canvas_width_m = 2;
  EXPECT_EQ(
      error({}, other),
      "the canvas is 1 x 0.75 m, the other log's 2 x 0.75 m; a copy made with --fit can be merged");
  other = {};
  other.steps_per_second = 60;
  EXPECT_EQ(error({}, other), "steps_per_second is 45, the other log's 60");
  Header first;
  first.palette = {pigment("a", 0.5)};
  other = {};
  other.palette = {pigment("a", 0.6)};
  EXPECT_EQ(error(first, other), "the pigment \"a\" is another one in each log");
  first = {}, other = {};
  first.brushes = {brush("x", "flat")};
  other.brushes = {brush("x", "fan")};
  EXPECT_EQ(error(first, other), "the brush \"x\" is another one in each log");
}

}  // namespace
}  // namespace pentimento::log
