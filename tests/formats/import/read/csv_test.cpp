#include <set>

#include "core/optics/srgb.h"
#include "formats/import/read/readers.h"
#include "formats/import/recording_file.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read(std::string_view text, const CsvColumns& columns = {}) {
  ReadOptions options;
  options.csv = columns;
  return read_csv({"a.csv", text}, options);
}
const Stroke& stroke(const Result<Sketch>& sketch, std::size_t i) {
  return std::get<Stroke>(sketch->items.at(i));
}

TEST(Csv, FindsColumnsByTheirUsualNames) {
  const std::string text =
      "\xEF\xBB\xBFStroke, T ,X,Y,Pressure,tilt_x,Twist,width,colour\r\n"
      "1,0,10,20,0.5,-30,90,2,#ff0000\r\n1,0.5,11,21,0.25,0,0,3,#ff0000\r\n\r\n"
      "2,1,12,22,1,10,-5,4,#00f\r\n";
  ASSERT_EQ(format_of(text), find_format("csv"));
  const Result<Sketch> sketch = read(text);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  ASSERT_EQ(sketch->items.size(), 2u);
  const Stroke& first = stroke(sketch, 0);
  ASSERT_EQ(first.samples.size(), 2u);
  EXPECT_EQ(first.samples[1].x, 11);
  EXPECT_EQ(first.samples[1].y, 21);
  EXPECT_EQ(first.samples[1].time_s, 0.5);
  EXPECT_EQ(first.samples[0].tilt_x_deg, -30);
  EXPECT_EQ(first.samples[0].twist_deg, 90);
  EXPECT_EQ(first.width, 3);  // the widest
  EXPECT_EQ(first.color, (log::Rgb{1, 0, 0}));
  EXPECT_EQ(stroke(sketch, 1).color, (log::Rgb{0, 0, 1}));
  EXPECT_TRUE(first.timed && first.has_pressure && first.has_tilt && first.has_twist);
}

TEST(Csv, TakesAColumnMapByNamesAndNumbersWithUnits) {
  CsvColumns columns;
  columns.x = "2";
  columns.y = "3";
  columns.time = "1";
  columns.second_per_unit = 0.001;
  columns.metre_per_unit = 0.01;
  columns.y_up = true;
  const Result<Sketch> numbers = read("0\t1\t2\n500\t3\t4\n", columns);
  ASSERT_TRUE(numbers) << numbers.error().message;
  EXPECT_EQ(stroke(numbers, 0).samples[1].x, 3);
  EXPECT_EQ(stroke(numbers, 0).samples[1].y, -4);
  EXPECT_EQ(stroke(numbers, 0).samples[1].time_s, 0.5);
  EXPECT_EQ(numbers->metre_per_unit, 0.01);
  CsvColumns named;
  named.x = "east";
  named.y = "north";
  const Result<Sketch> sketch = read("north;east\n1;2\n", named);
  ASSERT_TRUE(sketch) << sketch.error().message;
  EXPECT_EQ(stroke(sketch, 0).samples[0].x, 2);
}

TEST(Csv, LeaningComesFromAltitudeAndAzimuthAndColourFromThreeColumns) {
  const Result<Sketch> sketch = read(
      "x_px,y_px,stroke,altitude_rad,azimuth_rad,r,g,b,brush\n"
      "1,2,0,0.7853981634,0,255,0,51,Circle\n1,3,0,1.5707963267,1,0,0,0,Circle\n"
      "1,2,1,0.7853981634,1.5707963268,0,1,0,Circle\n");
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  const Stroke& first = stroke(sketch, 0);
  ASSERT_TRUE(first.has_tilt);
  EXPECT_NEAR(first.samples[0].tilt_x_deg, 45, 1e-4);  // leaning to the right
  EXPECT_NEAR(first.samples[0].tilt_y_deg, 0, 1e-4);
  EXPECT_NEAR(first.samples[1].tilt_x_deg, 0, 1e-4);               // upright
  EXPECT_NEAR(stroke(sketch, 1).samples[0].tilt_y_deg, 45, 1e-4);  // towards the painter
  EXPECT_NEAR(first.color[0], 1, 1e-12);
  EXPECT_NEAR(first.color[2], srgb_to_linear(0.2), 1e-12);
  EXPECT_NEAR(stroke(sketch, 1).color[1], srgb_to_linear(1 / 255.0), 1e-12) << "one scale for all";
  EXPECT_EQ(sketch->report.dropped, std::vector<std::string>{"column brush"});
  EXPECT_NEAR(stroke(read("x,y,r,g,b\n1,1,0.5,0,1\n"), 0).color[0], srgb_to_linear(0.5), 1e-12);
  EXPECT_EQ(read("x,y,altitude_rad,azimuth_rad\n1,1,45,0\n").error().message,
            "a.csv:2: altitude_rad 45 is outside 0..1.5707963267948966");
  const Result<Sketch> alone = read("x,y,r,azimuth_rad\n1,1,9,9\n");
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_FALSE(stroke(alone, 0).has_tilt);
  EXPECT_EQ(alone->report.dropped, (std::vector<std::string>{"column r", "column azimuth_rad"}));
  CsvColumns red;
  red.red = "r";
  EXPECT_EQ(read("x,y,r\n1,1,1\n", red).error().message,
            "a.csv:1: a colour needs columns of red, green and blue");
}

// Tables that were made from recordings that are read themselves, and their SOURCE.txt.
TEST(Csv, ReadsRealTables) {
  CsvColumns projected;
  projected.x = "u";
  projected.y = "v";
  struct Truth {
    const char* name;
    CsvColumns columns;
    int strokes, samples, colors;
    bool has_tilt;
  };
  for (const Truth& truth : {Truth{"tables/digital-ink-processable.csv", {}, 177, 2787, 3, true},
                             {"tables/hello-world.csv", {}, 623, 15208, 6, true},
                             {"tables/OilPaint.csv", projected, 67, 1231, 1, false}}) {
    const Result<std::string> bytes =
        read_recording(std::string(PENTIMENTO_TEST_DATA) + "/recordings/" + truth.name + ".gz");
    ASSERT_TRUE(bytes) << bytes.error().message;
    const Result<Sketch> sketch = read(*bytes, truth.columns);
    ASSERT_TRUE(sketch) << sketch.error().message;
    expect_sound(*sketch);
    EXPECT_EQ(counts_of(*sketch).strokes, truth.strokes) << truth.name;
    EXPECT_EQ(counts_of(*sketch).samples, truth.samples) << truth.name;
    std::set<log::Rgb> colors;
    for (const Item& item : sketch->items) colors.insert(std::get<Stroke>(item).color);
    EXPECT_EQ(static_cast<int>(colors.size()), truth.colors) << truth.name;
    EXPECT_EQ(stroke(sketch, 0).has_tilt, truth.has_tilt) << truth.name;
  }
}

TEST(Csv, StrokesEndWhereThePenIsUpOrThePressureIsZeroOrTimePasses) {
  EXPECT_EQ(read("x,y,pen\n1,1,1\n2,2,0\n3,3,1\n")->items.size(), 2u);
  EXPECT_EQ(read("x,y,p\n1,1,0.5\n2,2,0\n3,3,1\n")->items.size(), 2u);
  EXPECT_EQ(read("x,y,t\n1,1,0\n2,2,0.4\n3,3,1\n")->items.size(), 2u);
  EXPECT_EQ(read("x,y\n1,1\n2,2\n3,3\n")->items.size(), 1u);
  EXPECT_EQ(read("1,1\n2,2\n")->items.size(), 1u);  // no names
}

TEST(Csv, StrokesOfTheirOwnNumbersMayOverlapAndHoverNowhere) {
  const Result<Sketch> sketch =
      read("stroke,t,x,y,pressure\n1,0,1,1,0\n1,5,2,2,0.5\n1,6,3,3,0\n2,4,7,7,0.1\n2,7,8,8,0.2\n");
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 2u);
  EXPECT_EQ(stroke(sketch, 0).samples.size(), 3u) << "a light touch is of the stroke";
  EXPECT_EQ(stroke(sketch, 1).samples[0].time_s, 4);
  EXPECT_EQ(read("stroke,t,x,y\n1,5,1,1\n1,4,2,2\n").error().message, "a.csv:3: time 4 runs back");
}

TEST(Csv, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> bad[] = {
      {"x,y\n1,2\n3\n", "a.csv:3: 1 columns, the first line has 2"},
      {"x,y\n1,b\n", "a.csv:2: 'b' is not a number"},
      {"x,y\ninf,1\n", "a.csv:2: 'inf' is not a number"},
      {"x,y,p\n1,1,1.5\n", "a.csv:2: pressure 1.5 is outside 0..1"},
      {"x,y,tilt_x\n1,1,91\n", "a.csv:2: tilt_x 91 is outside -90..90"},
      {"x,y,t\n1,1,5\n1,1,4\n", "a.csv:3: time 4 runs back"},
      {"x,y,width\n1,1,-1\n", "a.csv:2: width -1 is negative"},
      {"x,y,color\n1,1,rad\n", "a.csv:2: 'rad' is not a colour"},
      {"a,y\n1,1\n", "a.csv:1: no column is called 'x'"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
  CsvColumns far;
  far.time = "9";
  EXPECT_EQ(read("1,2\n", far).error().message, "a.csv:1: there is no column 9, only 2");
  CsvColumns named;
  named.time = "t";
  EXPECT_EQ(read("1,2\n", named).error().message,
            "a.csv:1: the columns have no names; 't' must be a number");
}

TEST(Csv, OtherTablesAreNoDrawings) {
  for (const char* text : {"a,b\n1,2\n", "hello\n", "x,y\n1\n", "t_s,grav_x_g,grav_y_g\n0,1,2\n"})
    EXPECT_EQ(format_of(text), nullptr) << text;
}

TEST(Csv, NoDamageDoesHarm) {
  std::string text = "stroke,t,x,y,p,tilt_x,tilt_y,twist,width,color\n";
  for (int i = 0; i < 300; ++i)
    text += std::to_string(i / 20) + "," + std::to_string(i) + ",1.5,2.5,0.5,1,2,3,4,#123456\n";
  expect_no_harm_by_damage("csv", text, 200);
}

}  // namespace
}  // namespace pentimento::sketch
