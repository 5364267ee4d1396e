#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read(const std::string& inside) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<ink xmlns=\"http://www.w3.org/2003/InkML\">" + inside + "</ink>";
  return read_inkml({"a.inkml", text}, {});
}

const Stroke& stroke_of(const Result<Sketch>& sketch, std::size_t i = 0) {
  EXPECT_TRUE(sketch) << (sketch ? "" : sketch.error().message);
  if (!sketch || sketch->items.size() <= i) {
    ADD_FAILURE() << "no stroke " << i;
    static const Stroke none{.samples = std::vector<Sample>(8)};
    return none;
  }
  return std::get<Stroke>(sketch->items[i]);
}

std::vector<double> xs(const Stroke& stroke) {
  std::vector<double> out;
  for (const Sample& s : stroke.samples) out.push_back(s.x);
  return out;
}
std::vector<double> ys(const Stroke& stroke) {
  std::vector<double> out;
  for (const Sample& s : stroke.samples) out.push_back(s.y);
  return out;
}
using Values = std::vector<double>;

/// Channels with units, a brush, times: most that the format has.
const std::string kRich = R"(
<definitions>
  <brush xml:id="red"><brushProperty name="width" value="2" units="mm"/>
    <brushProperty name="color" value="#FF0000"/>
    <brushProperty name="transparency" value="51"/></brush>
  <traceFormat xml:id="f"><channel name="X" units="cm"/><channel name="Y" units="cm"/>
    <channel name="F" min="0" max="1000"/><channel name="OA"/><channel name="OE"/>
    <intermittentChannels><channel name="T" units="ms"/></intermittentChannels></traceFormat>
  <context xml:id="c" traceFormatRef="#f" brushRef="#red"/>
</definitions>
<traceGroup contextRef="#c"><traceGroup>
  <trace timeOffset="1000">1 2 500 0 45 0, 3 4 1000 90 90 20</trace></traceGroup>
  <trace type="penUp">1 2 500 0 45 0</trace>
</traceGroup>)";

TEST(InkMl, ReadsPlainPoints) {
  const Result<Sketch> sketch = read("<trace>10 0, 9 14, 8 28</trace><trace>130 155</trace>");
  EXPECT_EQ(xs(stroke_of(sketch)), (Values{10, 9, 8}));
  EXPECT_EQ(ys(stroke_of(sketch)), (Values{0, 14, 28}));
  EXPECT_EQ(xs(stroke_of(sketch, 1)), (Values{130}));
  EXPECT_FALSE(stroke_of(sketch).timed);
}

TEST(InkMl, AddsDifferences) {
  // The example of the specification, sec. 3.2.1: first values, velocities, then accelerations.
  const Result<Sketch> sketch =
      read("<trace>1125 18432,'23'43,\"7\"-8,3-5,7 -3,6 2,6 8,3 6 T,2 4*T,3 6,3-6 F F</trace>");
  EXPECT_FALSE(sketch);  // that format has two more channels
  const Result<Sketch> two = read("<trace>1125 18432,'23'43,\"7\"-8,3-5,7 -3,* *,!5!6,7 8</trace>");
  EXPECT_EQ(xs(stroke_of(two)), (Values{1125, 1148, 1178, 1211, 1251, 1298, 5, 7}));
  EXPECT_EQ(ys(stroke_of(two)), (Values{18432, 18475, 18510, 18540, 18567, 18591, 6, 8}));
}

TEST(InkMl, RepeatsByMode) {
  const Result<Sketch> sketch = read("<trace>5 5, * '2, * *, ? *, #1F +3.5</trace>");
  EXPECT_EQ(xs(stroke_of(sketch)), (Values{5, 5, 5, 5, 31}));
  EXPECT_EQ(ys(stroke_of(sketch)), (Values{5, 7, 9, 11, 14.5}));
}

TEST(InkMl, InheritsContextFormatAndBrush) {
  const Result<Sketch> sketch = read(kRich);
  const Stroke& stroke = stroke_of(sketch);
  ASSERT_EQ(stroke.samples.size(), 2u);
  EXPECT_NEAR(stroke.samples[0].x, 0.01, 1e-12);
  EXPECT_NEAR(stroke.samples[1].y, 0.04, 1e-12);
  EXPECT_EQ(stroke.samples[0].pressure, 0.5f);
  EXPECT_NEAR(stroke.samples[0].tilt_x_deg, 45, 1e-4);
  EXPECT_NEAR(stroke.samples[1].tilt_y_deg, 0, 1e-4);
  EXPECT_NEAR(stroke.samples[1].time_s, 1.02, 1e-9);
  EXPECT_TRUE(stroke.timed && stroke.has_pressure && stroke.has_tilt);
  EXPECT_NEAR(stroke.width, 0.002, 1e-12);
  EXPECT_EQ(stroke.color, (log::Rgb{1, 0, 0}));
  EXPECT_NEAR(stroke.opacity, 0.8, 1e-12);
  EXPECT_EQ(sketch->items.size(), 1u);
  EXPECT_EQ(sketch->report.dropped, (std::vector<std::string>{"1 traces in the air"}));
}

TEST(InkMl, TurnsAndScalesChannels) {
  const Result<Sketch> sketch = read(R"(<context><inkSource><traceFormat><channel name="X"/>
    <channel name="Y" orientation="-ve"/><channel name="S" type="boolean"/></traceFormat>
    <channelProperties><channelProperty channel="X" name="resolution" value="100" units="1/cm"/>
    <channelProperty channel="Y" name="resolution" value="100" units="1/cm"/></channelProperties>
    </inkSource></context><trace>100 100 T, 200 100 F, 300 100 T</trace>)");
  EXPECT_NEAR(stroke_of(sketch).samples[0].x, 0.01, 1e-12);
  EXPECT_NEAR(stroke_of(sketch).samples[0].y, -0.01, 1e-12);
  EXPECT_EQ(sketch->items.size(), 2u);  // the pen was up between
}

TEST(InkMl, JoinsContinuedTraces) {
  const Result<Sketch> sketch = read(
      R"(<trace xml:id="a" continuation="begin">1 1</trace><trace>9 9</trace>
      <trace xml:id="b" continuation="middle" priorRef="#a">2 2</trace>
      <trace continuation="end" priorRef="#b">3 3</trace>)");
  EXPECT_EQ(xs(stroke_of(sketch)), (Values{1, 2, 3}));
  EXPECT_EQ(sketch->items.size(), 2u);
}

TEST(InkMl, ScalesForceWithoutARange) {
  const Result<Sketch> sketch = read(R"(<traceFormat><channel name="X"/><channel name="Y"/>
      <channel name="F"/></traceFormat><trace>0 0 512, 1 1 2048</trace>)");
  EXPECT_EQ(stroke_of(sketch).samples[0].pressure, 0.25f);
  EXPECT_EQ(stroke_of(sketch).samples[1].pressure, 1.0f);
}

TEST(InkMl, RefusesDamage) {
  const char* const bad[] = {
      "<trace>1</trace>",
      "<trace>1 2 3</trace>",
      "<trace>1 nan</trace>",
      "<trace>1 inf</trace>",
      "<trace>1 1e13</trace>",
      "<trace>1 x</trace>",
      "<trace>\"9e11 0, 9e11 0</trace>",
      R"(<context xml:id="a" contextRef="#b"/><context xml:id="b" contextRef="#a"/>)",
      R"(<context xml:id="a" contextRef="#a" brushRef="#a" traceFormatRef="#a"/>)",
      R"(<traceFormat><channel name="X"/><channel name="Z"/></traceFormat><trace>1 2</trace>)",
      R"(<traceFormat><channel name="X"/><channel name="Y"/><channel name="T"/></traceFormat>
         <trace>1 2 3, 1 2 2</trace>)",
      "<trace>"};
  for (const char* inside : bad) {
    const Result<Sketch> sketch = read(inside);
    ASSERT_FALSE(sketch) << inside;
    EXPECT_TRUE(sketch.error().message.starts_with("a.inkml: offset ")) << sketch.error().message;
  }
  EXPECT_EQ(read("<trace>1 2, 3</trace>").error().message,
            "a.inkml: offset 65: point 2: 1 values, no Y");
}

TEST(InkMl, LimitsNesting) {
  std::string deep, ends;
  for (int i = 0; i < 20000; ++i) {
    deep += "<traceGroup>";
    ends += "</traceGroup>";
  }
  const Result<Sketch> sketch = read(deep + ends);
  ASSERT_FALSE(sketch);
  EXPECT_EQ(sketch.error().code, ErrorCode::kLimit);
}

TEST(InkMl, IsToldByItsRoot) {
  EXPECT_TRUE(is_inkml("\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- a > b --><i:ink xmlns:i='x'/>"));
  for (const char* other : {"", "<", "<svg/>", "ink", "<!--", "<inkscape/>", "<?xml?>", "{}"})
    EXPECT_FALSE(is_inkml(other)) << other;
}

TEST(InkMl, NoDamageDoesHarm) {
  expect_no_harm_by_damage("inkml", "<ink>" + kRich + "</ink>", 3000);
}

TEST(InkMl, TellsWhatIsKeptAsFarAsItIsThere) {
  const auto kept = [](const std::string& text) {
    return read_inkml({"a.inkml", text}, {})->report.kept;
  };
  EXPECT_EQ(kept("<ink><trace>1 1, 2 2</trace></ink>"), (std::vector<std::string>{"places"}));
  EXPECT_EQ(kept(R"(<ink><definitions><brush xml:id="b"><brushProperty name="width" value="2"/>)"
                 R"(<brushProperty name="color" value="#FF8000"/></brush></definitions>)"
                 R"(<trace brushRef="#b">1 1, 2 2</trace></ink>)"),
            (std::vector<std::string>{"places", "colour", "width"}));
}

}  // namespace
}  // namespace pentimento::sketch
