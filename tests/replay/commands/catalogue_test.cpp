#include "replay/commands/catalogue.h"

#include <gtest/gtest.h>

#include <set>

#include "formats/log/tables/slider_fields.h"

namespace pentimento {
namespace {

Catalogue listed(std::string_view kind, std::string_view name = {}) {
  Result<Catalogue> found = catalogue(kind, name);
  EXPECT_TRUE(found) << found.error().message;
  return found ? *found : Catalogue{};
}

TEST(Catalogue, HasEveryRowOnceWithACellPerColumn) {
  for (const std::string_view kind : catalogue_names()) {
    const Catalogue all = listed(kind);
    EXPECT_EQ(all.kind, kind);
    EXPECT_EQ(all.columns.front(), "name");
    std::set<std::string> names;
    for (const auto& row : all.rows) {
      EXPECT_EQ(row.size(), all.columns.size()) << kind;
      EXPECT_TRUE(names.insert(row.front().text).second) << row.front().text;
    }
    EXPECT_GT(names.size(), 1u) << kind;
  }
  EXPECT_EQ(listed("brushes").rows.size(), 8u);
  EXPECT_EQ(listed("pigments").rows.size(), 48u);
}

TEST(Catalogue, FindsNamesByAPartOfThem) {
  const Catalogue blue = listed("pigments", "ULTRAMARINE");
  std::vector<std::string> names;
  for (const auto& row : blue.rows) names.push_back(row.front().text);
  EXPECT_EQ(names, (std::vector<std::string>{"French Ultramarine", "Ultramarine Blue",
                                             "Golden Ultramarine Blue"}));
  // As the library's source has it beside the name.
  EXPECT_EQ(blue.rows[1][1].text, "#26309a");
  EXPECT_EQ(blue.rows[2][3].text, "true");
}

TEST(Catalogue, SaysWhatIsNearWhereNothingIsFound) {
  EXPECT_EQ(catalogue("pigments", "Cobalt Blu").value().rows.size(), 2u);
  EXPECT_EQ(catalogue("pigments", "Cobolt Blue").error().message,
            "no pigment is called \"Cobolt Blue\" (did you mean \"Cobalt Blue\"?)");
  EXPECT_EQ(
      catalogue("brush", "").error().message,
      "there is no list of \"brush\" (did you mean \"brushes\"?); there are brushes, pigments, "
      "parameters, formats, limits");
  EXPECT_EQ(catalogue("brush", "").error().code, ErrorCode::kUsage);
}

TEST(Catalogue, IsATableAndAnObject) {
  const Catalogue size = listed("parameters", "stiffness");
  EXPECT_EQ(catalogue_text(size),
            "name       unit  range  default  in      reason\n"
            "stiffness        0..1   0.5      slider  a brush of middling bristle\n");
  EXPECT_EQ(catalogue_json(size),
            R"({"parameters":[{"name":"stiffness","unit":"","range":"0..1","default":0.5,)"
            R"("in":"slider","reason":"a brush of middling bristle"}]})");
}

}  // namespace
}  // namespace pentimento
