#include <gtest/gtest.h>

#include "core/optics/srgb.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

std::string with(const std::string& members) {
  return R"({"type":"header","format":"pentimento-log","version":1,)" + members + "}\n";
}
const std::string kCanvas = R"("canvas":{"width":1,"height":0.75},)";

TEST(Header, HasTheDocumentedDefaults) {
  const Outcome outcome = read_text(kHeaderLine);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  const Header& header = outcome.header;
  EXPECT_EQ(header.grid_width, 1024);
  EXPECT_EQ(header.grid_height, 768);
  EXPECT_EQ(header.steps_per_second, 45);
  EXPECT_EQ(header.paper.texture, "linen");
  EXPECT_FALSE(header.edge_open);
  EXPECT_TRUE(header.palette.empty());
  EXPECT_EQ(header.model.layers, 2);
  EXPECT_EQ(header.model.max_medium_m, 0.05f);
}

TEST(Header, WithoutGridCellsAreSquareAnd1024AlongTheLongerSide) {
  const auto grid = [](const std::string& canvas) {
    const Header header = read_text(with(R"("canvas":)" + canvas)).header;
    return std::pair(header.grid_width, header.grid_height);
  };
  EXPECT_EQ(grid(R"({"width":2,"height":2})"), std::pair(1024, 1024));
  EXPECT_EQ(grid(R"({"width":0.3,"height":0.6})"), std::pair(512, 1024));
  EXPECT_EQ(grid(R"({"width":100,"height":0.001})"), std::pair(1024, 1));
}

TEST(Header, EveryFieldIsRead) {
  const Outcome outcome = read_text(with(
      R"("canvas":{"width":2,"height":1,"edge":"open"},"grid":{"width":64,"height":32},)"
      R"("steps_per_second":60,)"
      R"("paper":{"texture":"canvas","relief":0.001,"scale":0.2,"reflectance":[0.8,0.7,0.6]},)"
      R"("palette":[{"name":"a","over_white":"#1f2f8c","over_black":[0.01,0.01,0.1]},)"
      R"({"name":"b","K":[0.14,1.08,1.68],"S":[0.77,0.015,0.018]},)"
      R"({"name":"c","color":"#ff0000","opacity":0.5},{"name":"d","color":[0,0.5,1]},)"
      R"({"name":"e","spectrum":{"wavelength":[400,500,600],"K":[1,2,3],"S":[0,1,2]}},)"
      R"({"name":"ivory black"}],)"
      R"("brushes":[{"name":"mine","shape":"flat","spacing":0.05,"size_pressure":0.1,)"
      R"("flow_pressure":0.2,"follows_direction":true},{"name":"tex","texture":"tip.png"}],)"
      R"("model":{"scheme":"conservative","layers":4,"nu_min":1e-5,"optical_thickness":"depth",)"
      R"("phi_scales_lateral":false},)"
      R"("title":"T","author":"A","recorded_by":"R","recorded_at":"2026-11-21T10:00:00Z",)"
      R"("x-note":{"a":[1,"b"]})"));
  ASSERT_TRUE(outcome.ok) << outcome.message;
  const Header& header = outcome.header;
  EXPECT_TRUE(header.edge_open);
  EXPECT_EQ(header.grid_height, 32);
  EXPECT_EQ(header.steps_per_second, 60);
  EXPECT_EQ(header.paper.texture, "canvas");
  EXPECT_EQ(header.paper.reflectance, (Rgb{0.8, 0.7, 0.6}));
  ASSERT_EQ(header.palette.size(), 6u);
  EXPECT_EQ((*header.palette[0].over_white)[0], srgb_to_linear(0x1f / 255.0));
  EXPECT_EQ((*header.palette[0].over_black)[2], 0.1);
  EXPECT_EQ((*header.palette[1].K)[2], 1.68);
  EXPECT_EQ(header.palette[2].opacity, 0.5);
  EXPECT_EQ(header.palette[3].opacity, 0.7);
  EXPECT_EQ(header.palette[4].spectrum->wavelength_nm[1], 500);
  EXPECT_TRUE(header.palette[5].library);
  ASSERT_EQ(header.brushes.size(), 2u);
  EXPECT_EQ(header.brushes[0].follows_direction, true);
  EXPECT_EQ(header.brushes[1].texture, "tip.png");
  EXPECT_EQ(header.model.scheme, SchemeKind::kConservative);
  EXPECT_EQ(header.model.layers, 4);
  EXPECT_EQ(header.model.nu_min_m2_s, 1e-5f);
  EXPECT_EQ(header.model.optical_thickness, OpticalThickness::kDepth);
  EXPECT_FALSE(header.model.phi_scales_lateral);
  EXPECT_EQ(header.recorded_at, "2026-11-21T10:00:00Z");
  EXPECT_EQ(header.extensions, R"("x-note":{"a":[1,"b"]})");
}

struct BadHeader {
  std::string line;
  std::string message;
};

void PrintTo(const BadHeader& bad, std::ostream* out) {
  *out << bad.line;
}

class BadHeaders : public testing::TestWithParam<BadHeader> {};

TEST_P(BadHeaders, AreNamedByFieldValueAndLimit) {
  const Outcome outcome = read_text(GetParam().line);
  EXPECT_FALSE(outcome.ok);
  EXPECT_EQ(outcome.code, ErrorCode::kBadInput);
  EXPECT_EQ(outcome.message, "a.jsonl:1: " + GetParam().message);
}

const BadHeader kIdentity[] = {
    {"", "the log is empty"},
    {"\n \r\n", "the log is empty"},
    {"{\"t\":0,\"type\":\"dry\"}\n", R"(line 1 is not a header: its type is not "header")"},
    {"{}\n", R"(line 1 is not a header: its type is not "header")"},
    {"hello\n", "not valid JSON: column 1: invalid literal"},
    {"\xef\xbb\xbf{}\n", "the log starts with a byte order mark, to be left out"},
    {"\xff\xfe{", "the log starts with UTF-16, not UTF-8"},
    {R"({"type":"header","format":"other","version":1})",
     R"(format "other" is not "pentimento-log")"},
    {R"({"type":"header","version":1})", "format is missing"},
    {R"({"type":"header","format":"pentimento-log"})", "version is missing"},
    {R"({"type":"header","format":"pentimento-log","version":0})",
     "version 0 is outside 1..9007199254740991"},
    {R"({"type":"header","format":"pentimento-log","version":1.5})",
     "version 1.5 is not a whole number"},
    {R"({"type":"header","format":"pentimento-log","version":2,"colour":1})",
     "version 2 is newer than 1, the newest known"},
    {R"({"type":"header","format":"pentimento-log","version":1})", "canvas is missing"},
    {R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"wi)",
     "the log is cut short in its first line"},
};
INSTANTIATE_TEST_SUITE_P(Identity, BadHeaders, testing::ValuesIn(kIdentity));

const BadHeader kFrame[] = {
    {with(R"("canvas":1)"), "canvas 1 is not an object"},
    {with(R"("canvas":{"height":1})"), "canvas.width is missing"},
    {with(R"("canvas":{"width":1})"), "canvas.height is missing"},
    {with(R"("canvas":{"width":0,"height":1})"), "canvas.width 0 is outside 0.001..100 m"},
    {with(R"("canvas":{"width":1,"height":1,"edge":"soft"})"),
     R"(canvas.edge "soft" is not closed, open)"},
    {with(R"("canvas":{"width":1,"height":1,"depth":1})"), R"(unknown field "canvas.depth")"},
    {with(kCanvas + R"("grid":{"width":16385,"height":1})"),
     "grid.width 16385 is outside 1..16384 cells"},
    {with(kCanvas + R"("grid":{"width":1.5,"height":1})"), "grid.width 1.5 is not a whole number"},
    {with(kCanvas + R"("grid":{"width":1})"), "grid.height is missing"},
    {with(kCanvas + R"("steps_per_second":0)"), "steps_per_second 0 is outside 1..10000"},
    {with(kCanvas + R"("paper":{"relief":1})"), "paper.relief 1 is outside 0..0.1 m"},
    {with(kCanvas + R"("paper":{"scale":0})"), "paper.scale 0 is outside 0.0001..100 m"},
    {with(kCanvas + R"("paper":{"reflectance":[1,1]})"),
     "paper.reflectance [1,1] is not an array of three numbers"},
    {with(kCanvas + R"("paper":{"texture":"../x.png"})"),
     R"(paper.texture: file "../x.png" leaves the log's folder)"},
    {with(kCanvas + R"("titel":"a")"), R"(unknown field "titel" (did you mean "title"?))"},
    {with(kCanvas + R"("title":3)"), "title 3 is not a string"},
    {with(kCanvas + R"("title":"a","title":"b")"), R"(duplicate key "title")"},
};
INSTANTIATE_TEST_SUITE_P(Frame, BadHeaders, testing::ValuesIn(kFrame));

std::string palette(const std::string& entries) {
  return with(kCanvas + R"("palette":[)" + entries + "]");
}

const BadHeader kPalette[] = {
    {with(kCanvas + R"("palette":{})"), "palette {} is not an array"},
    {palette("1"), "palette[0] is not an object"},
    {palette("{}"), "palette[0].name is missing"},
    {palette(R"({"name":""})"), R"(palette[0].name "" is empty)"},
    {palette(R"({"name":"ivory blak"})"),
     R"(palette[0].name "ivory blak" is no pigment of the library, and no colour is given)"
     R"( (did you mean "Ivory Black"?))"},
    {palette(R"({"name":"a","over_white":"#ffffff"})"), "palette[0].over_black is missing"},
    {palette(R"({"name":"a","over_black":"#ffffff"})"), "palette[0].over_white is missing"},
    {palette(R"({"name":"a","over_white":[0.1,0.1,0.1],"over_black":[0.1,0.2,0.1]})"),
     "palette[0].over_black [0.1,0.2,0.1] is lighter than over_white (0.2 > 0.1 in band 1)"},
    {palette(R"({"name":"a","K":[1,1,1]})"), "palette[0].S is missing"},
    {palette(R"({"name":"a","S":[1,1,1]})"), "palette[0].K is missing"},
    {palette(R"({"name":"a","K":[1,1,-1],"S":[1,1,1]})"),
     "palette[0].K[2] -1 is outside 0..1000000"},
    {palette(R"({"name":"a","color":"#ff0000","K":[1,1,1],"S":[1,1,1]})"),
     R"(palette[0].name "a" is given in more than one way)"},
    {palette(R"({"name":"a","color":"#ff0000","opacity":1})"),
     "palette[0].opacity 1 is outside 0..1, both excluded"},
    {palette(R"({"name":"a","opacity":0.5})"), "palette[0].color is missing"},
    {palette(R"({"name":"a","color":"#ff0000"},{"name":"a","color":"#00ff00"})"),
     R"(palette[1].name "a" is there twice)"},
    {palette(R"({"name":"a","spectrum":{"wavelength":[400,500],"K":[1,1],"S":[1,1]}})"),
     "palette[0].spectrum.wavelength has 2 bands, outside 3..1000"},
    {palette(R"({"name":"a","spectrum":{"wavelength":[400,500,500],"K":[1,1,1],"S":[1,1,1]}})"),
     "palette[0].spectrum.wavelength[2] 500 is not above the one before"},
    {palette(R"({"name":"a","spectrum":{"wavelength":[400,500,600],"K":[1,1],"S":[1,1,1]}})"),
     "palette[0].spectrum.K has 2 and palette[0].spectrum.S 3 values for 3 wavelengths"},
};
INSTANTIATE_TEST_SUITE_P(Palette, BadHeaders, testing::ValuesIn(kPalette));

const BadHeader kBrushesAndModel[] = {
    {with(kCanvas + R"("brushes":[{"name":"a"}])"),
     R"(brushes[0].name "a" needs either shape or texture)"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","bristles":{"count":0}}])"),
     "brushes[0].bristles.count 0 is outside 1..2000"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","bristles":{"cuont":9}}])"),
     R"(unknown field "brushes[0].bristles.cuont" (did you mean "count"?))"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"knife","bristles":{"count":9}}])"),
     "brushes[0].bristles: a knife has none"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","capacity":0}])"),
     "brushes[0].capacity 0 is outside 1..1000000 diameters"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","pressure":{"size":[]}}])"),
     "brushes[0].pressure.size has 0 points, outside 1..16"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","pressure":{"size":[[0,1],[0,2]]}}])"),
     "brushes[0].pressure.size[1] pressure 0 is not above the one before"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","pressure":{"flow":[[0,5]]}}])"),
     "brushes[0].pressure.flow[0][1] 5 is outside 0..4"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","pressure":{"splay":[[0]]}}])"),
     "brushes[0].pressure.splay[0] [0] is not an array of two numbers"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"oval"}])"),
     R"(brushes[0].shape "oval" is not round, flat, filbert, bristle, fan, rigger, knife, rag)"},
    {with(kCanvas + R"("brushes":[{"shape":"flat"}])"), "brushes[0].name is missing"},
    {with(kCanvas + R"("brushes":[{"name":"a","shape":"flat","spacing":0}])"),
     "brushes[0].spacing 0 is outside 0.001..10 diameters"},
    {with(kCanvas + R"("brushes":[{"name":"a","texture":"/tip.png"}])"),
     R"(brushes[0].texture: file "/tip.png" is an absolute path)"},
    {with(kCanvas + R"("model":{"layers":9})"), "model.layers 9 is outside 1..8"},
    {with(kCanvas + R"("model":{"scheme":"fast"})"),
     R"(model.scheme "fast" is not paper, conservative)"},
    {with(kCanvas + R"("model":{"superbee":1})"), "model.superbee 1 is not true or false"},
    {with(kCanvas + R"("model":{"nu_maks":1})"),
     R"(unknown field "model.nu_maks" (did you mean "nu_max"?))"},
    {with(kCanvas + R"("model":{"gamma":0.9})"), "model.gamma 0.9 is not below zeta 0.8"},
};
INSTANTIATE_TEST_SUITE_P(BrushesAndModel, BadHeaders, testing::ValuesIn(kBrushesAndModel));

}  // namespace
}  // namespace pentimento::log
