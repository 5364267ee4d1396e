#include <gtest/gtest.h>

#include "formats/import/sketch/recording.h"

namespace pentimento::sketch {
namespace {

TEST(Formats, HaveNamesOfTheirOwnAndAreFoundByThem) {
  for (const Format& format : formats()) {
    EXPECT_EQ(find_format(format.name), &format);
    EXPECT_FALSE(format.title.empty());
    EXPECT_TRUE(format.extensions.starts_with('.')) << format.name;
  }
  EXPECT_EQ(find_format("nonsense"), nullptr);
}

TEST(Formats, NoneReadsWhatIsNothing) {
  for (const std::string_view bytes :
       {std::string_view(), std::string_view("\0\0\0\0", 4), std::string_view("hello"),
        std::string_view("{}"), std::string_view("\x89PNG\r\n\x1a\n")})
    EXPECT_EQ(format_of(bytes), nullptr) << bytes;
}

}  // namespace
}  // namespace pentimento::sketch
