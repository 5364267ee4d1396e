#include "formats/log/json/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

std::string suggested(std::string_view name) {
  const std::vector<std::string_view> names = {"Cobalt Blue", "Golden Cobalt Blue",
                                               "Cadmium Red", "French Ultramarine",
                                               "tilt-brush",  "size"};
  return did_you_mean(name, names);
}

TEST(NearestName, IsTheOneWithFewChanges) {
  EXPECT_EQ(suggested("Cobolt Blue"), " (did you mean \"Cobalt Blue\"?)");
  EXPECT_EQ(suggested("siz"), " (did you mean \"size\"?)");
}

TEST(NearestName, ElseThoseThatContainIt) {
  EXPECT_EQ(suggested("ultramarine"), " (did you mean \"French Ultramarine\"?)");
}

TEST(NearestName, ElseThoseWithAWordOfFewChanges) {
  EXPECT_EQ(suggested("Cobat"), " (did you mean \"Cobalt Blue\" or \"Golden Cobalt Blue\"?)");
  EXPECT_EQ(suggested("cadmum"), " (did you mean \"Cadmium Red\"?)");
  EXPECT_EQ(suggested("brusch"), " (did you mean \"tilt-brush\"?)");
}

TEST(NearestName, IsNoneWhereNothingIsNear) {
  for (const char* name : {"", "xyz", "Vermilion", "Gld"}) EXPECT_EQ(suggested(name), "") << name;
}

}  // namespace
}  // namespace pentimento
