#include "formats/exr/typed_attribute.h"

#include <gtest/gtest.h>

#include <string>

namespace pentimento::exr {
namespace {

TEST(TypedAttribute, HasTheKindOfWhatItTells) {
  const std::pair<const char*, const char*> kinds[] = {
      {"5692", "int"},         {"-1", "int"},
      {"0.1", "double"},       {"1e-07", "double"},
      {"1024 x 768", "v2i"},   {"0.3127 0.329", "v2d"},
      {"0 -0.5 1e+30", "v3d"}, {"12345678901", "double"}};
  for (const auto& [text, kind] : kinds) {
    const auto attribute = typed_attribute(text);
    EXPECT_STREQ(attribute->typeName(), kind) << text;
    EXPECT_EQ(attribute_text(*attribute), text);
  }
}

TEST(TypedAttribute, IsATextWhereANumberWouldNotGiveItBack) {
  // A hash of digits alone, what is written otherwise than we write, what is no number.
  for (const char* text :
       {"1234567890123456789012345678901234567890123456789012345678901234", "010", "1.50", "+1",
        "1 2 3 4", "", " 1", "1 x", "pentimento 0.1.0", "1 x 2 x 3", "1.5 x 2.5", "nonsense"}) {
    const auto attribute = typed_attribute(text);
    EXPECT_STREQ(attribute->typeName(), "string") << text;
    EXPECT_EQ(attribute_text(*attribute), text);
  }
  EXPECT_STREQ(typed_attribute("\xff")->typeName(), "string");
}

}  // namespace
}  // namespace pentimento::exr
