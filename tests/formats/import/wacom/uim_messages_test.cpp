#include "formats/import/wacom/uim_messages.h"

#include <gtest/gtest.h>

#include "formats/import/wacom/uim.pb.h"

namespace pentimento::sketch {
namespace {

void add_channel(uim::ChannelGroup& group, const std::string& id, const std::string& type,
                 double resolution, unsigned precision, float max = 0) {
  uim::Channel& channel = *group.add_channels();
  channel.set_id(id);
  channel.set_type("will://input/3.0/channel/" + type);
  channel.set_resolution(resolution);
  channel.set_precision(precision);
  channel.set_max(max);
}
/// A pen that measures two samples, and a microphone.
uim::InputData pen() {
  uim::InputData input;
  uim::SensorContext& context = *input.mutable_context()->add_sensor_contexts();
  uim::ChannelGroup& group = *context.add_groups();
  add_channel(group, "x", "X", 4000, 1);
  add_channel(group, "y", "Y", 4000, 1);
  add_channel(group, "t", "Timestamp", 1000, 0);
  add_channel(group, "p", "Pressure", 1, 2, 4);
  add_channel(group, "a", "Altitude", 1, 1);
  uim::ChannelGroup& microphone = *context.add_groups();
  add_channel(microphone, "m", "Timestamp", 1000, 0);
  uim::SensorData& data = *input.add_sensor_data();
  data.set_id("s");
  data.set_timestamp(5000);
  const auto measure = [&](const char* id, int first, int step) {
    uim::ChannelData& channel = *data.add_channels();
    channel.set_channel_id(id);
    channel.add_deltas(first);
    channel.add_deltas(step);
  };
  measure("x", 100, 50), measure("y", 30, -10), measure("t", 0, 20), measure("p", 100, 200);
  measure("a", 15, -5), measure("m", 7, 7), measure("unknown", 1, 1);
  return input;
}
uim::InkData ink() {
  uim::InkData ink;
  ink.add_brushes("app://brush/Marker");
  ink.add_render_modes("will://rasterization/3.0/blend-mode/DestinationOut");
  uim::Property& property = *ink.add_properties();
  property.set_color(static_cast<int>(0xFF800040u));
  property.set_size(3);
  uim::Stroke& stroke = *ink.add_strokes();
  stroke.set_precisions(0x12);
  stroke.set_property(1);
  stroke.set_brush(1);
  stroke.set_render_mode(1);
  stroke.set_sensor_data_id("s");
  for (const int x : {1000, 250}) stroke.mutable_deltas()->add_x(x);
  for (const int y : {500, -100}) stroke.mutable_deltas()->add_y(y);
  for (const int size : {20, 5}) stroke.mutable_deltas()->add_size(size);
  return ink;
}
Result<UimInk> read(const uim::InputData& input, const uim::InkData& strokes) {
  return read_uim_31("in", input.SerializeAsString(), strokes.SerializeAsString());
}
std::string error_of(const uim::InputData& input, const uim::InkData& strokes) {
  const Result<UimInk> out = read(input, strokes);
  return out ? "none" : out.error().message;
}

TEST(UimMessages, ReadChannelsWithTheirUnits) {
  const Result<UimInk> out = read(pen(), ink());
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->sensors.size(), 1u);
  const UimSensor& sensor = out->sensors.at("s");
  EXPECT_NEAR(sensor.x_px.at(1), 15, 1e-12);
  EXPECT_NEAR(sensor.y_px.at(1), 2, 1e-12);
  ASSERT_EQ(sensor.time_s.size(), 2u) << "the microphone has times of its own";
  EXPECT_DOUBLE_EQ(sensor.time_s[1], 5.02);
  EXPECT_EQ(sensor.pressure, (std::vector<double>{0.25, 0.75})) << "of a full 4";
  EXPECT_EQ(sensor.altitude_rad, (std::vector<double>{1.5, 1}));
  EXPECT_TRUE(sensor.azimuth_rad.empty());
}

TEST(UimMessages, ReadStrokesWithTheirPrecisions) {
  const Result<UimInk> out = read(pen(), ink());
  ASSERT_TRUE(out);
  const UimStroke& stroke = out->strokes.at(0);
  EXPECT_EQ(stroke.x, (std::vector<double>{10, 12.5}));
  EXPECT_EQ(stroke.y, (std::vector<double>{5, 4}));
  EXPECT_EQ(stroke.size, (std::vector<double>{2, 2.5}));
  EXPECT_DOUBLE_EQ(stroke.color[0], 1);
  EXPECT_NEAR(stroke.color[1], 0.2159, 1e-4) << "0x80 of sRGB";
  EXPECT_DOUBLE_EQ(stroke.color[2], 0);
  EXPECT_DOUBLE_EQ(stroke.opacity, 0x40 / 255.0);
  EXPECT_DOUBLE_EQ(stroke.common_size, 3);
  EXPECT_EQ(stroke.brush, BrushKind::kFlat);
  EXPECT_TRUE(stroke.erases);
  EXPECT_EQ(stroke.sensor, "s");
}

TEST(UimMessages, IndicesPastTheEndMeanNothing) {
  uim::InkData past = ink();
  past.mutable_strokes(0)->set_property(9);
  past.mutable_strokes(0)->set_brush(4000000000u);
  past.mutable_strokes(0)->set_render_mode(2);
  const Result<UimInk> out = read(pen(), past);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->strokes[0].color, (log::Rgb{0, 0, 0}));
  EXPECT_EQ(out->strokes[0].brush, BrushKind::kRound);
  EXPECT_FALSE(out->strokes[0].erases);
}

TEST(UimMessages, AStrokeMayHaveAStyleOfItsOwn) {
  uim::InkData own = ink();
  uim::Stroke& stroke = *own.mutable_strokes(0);
  stroke.mutable_own_property()->set_color(static_cast<int>(0x0000FFFFu));
  stroke.mutable_own_property()->set_size(7);
  stroke.set_own_brush("will://toolkit/raster-brush/Crayon");
  stroke.set_own_render_mode("will://rasterization/3.0/blend-mode/SourceOver");
  const Result<UimInk> out = read(pen(), own);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->strokes[0].color, (log::Rgb{0, 0, 1}));
  EXPECT_DOUBLE_EQ(out->strokes[0].common_size, 7);
  EXPECT_EQ(out->strokes[0].brush, BrushKind::kBristle);
  EXPECT_FALSE(out->strokes[0].erases);
}

// One name of a megabyte that twenty thousand strokes mean: read once, not copied, not searched for
// each of them, which would take minutes. Strokes without points take no memory.
TEST(UimMessages, ALongNameOfManyStrokesCostsLittle) {
  uim::InkData many;
  many.add_brushes(std::string(1'000'000, 'x'));
  for (int i = 0; i < 20'000; ++i) many.add_strokes()->set_brush(1);
  many.mutable_strokes(7)->mutable_floats()->add_x(1);
  many.mutable_strokes(7)->mutable_floats()->add_y(1);
  const Result<UimInk> out = read(pen(), many);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->strokes.size(), 1u);
  EXPECT_EQ(out->empty_strokes, 19'999);
}

TEST(UimMessages, RefuseWhatCannotBe) {
  uim::InputData input = pen();
  const auto channel = [&](int i) {
    return input.mutable_context()->mutable_sensor_contexts(0)->mutable_groups(0)->mutable_channels(
        i);
  };
  channel(0)->set_resolution(0);
  EXPECT_EQ(error_of(input, ink()), "in: the resolution of X is 0");
  channel(0)->set_resolution(NAN);
  EXPECT_EQ(error_of(input, ink()), "in: the resolution of X is nan");
  channel(0)->set_resolution(1);
  channel(1)->set_precision(300);
  EXPECT_EQ(error_of(input, ink()), "in: the precision of Y is 300, over 9");
  input = pen();
  input.mutable_sensor_data(0)->set_timestamp(~std::uint64_t{0});
  EXPECT_NE(error_of(input, ink()).find("is too large"), std::string::npos);

  uim::InkData strokes = ink();
  strokes.mutable_strokes(0)->set_precisions(0x0F);
  EXPECT_EQ(error_of(pen(), strokes), "in: a precision is 15, over 9");
  strokes = ink();
  strokes.mutable_strokes(0)->mutable_deltas()->add_x(1);
  EXPECT_EQ(error_of(pen(), strokes), "in: a spline has 3 x and 2 y");
  strokes = ink();
  strokes.mutable_strokes(0)->clear_deltas();
  strokes.mutable_strokes(0)->mutable_floats()->add_x(INFINITY);
  strokes.mutable_strokes(0)->mutable_floats()->add_y(0);
  EXPECT_EQ(error_of(pen(), strokes), "in: a spline's value is inf");
  strokes = ink();
  strokes.mutable_properties(0)->set_size(-1);
  EXPECT_EQ(error_of(pen(), strokes), "in: a size is -1");
  EXPECT_EQ(read_uim_31("in", "\x0A\xFF", "").error().message, "in: the chunk INPT is damaged");
  EXPECT_EQ(read_uim_31("in", "", "\x0A\xFF").error().message, "in: the chunk INKD is damaged");
  EXPECT_EQ(read_uim_30("in", "\x0A\xFF").error().message, "in: the chunk DATA is damaged");
  EXPECT_TRUE(
      read_uim_json("in", "{\"inkData\":7}").error().message.starts_with("in: not its JSON: "));
  EXPECT_TRUE(read_uim_json("in", "").error().message.starts_with("in: not its JSON: "));
  // Nested as deep as it likes: no crash.
  std::string deep = "{\"inkData\":";
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
  EXPECT_FALSE(read_uim_json("in", deep));
}

TEST(UimMessages, JsonSaysTheSame) {
  const Result<UimInk> out = read_uim_json("in", R"({"inputData":{
      "inputContextData":{"sensorContexts":[{"sensorChannelsContext":[{"channels":[
        {"id":"x","type":"will://input/3.0/channel/X","resolution":4000.0,"precision":1,"metric":"LENGTH"},
        {"id":"t","type":"will://input/3.0/channel/Timestamp","resolution":1000.0}]}]}]},
      "sensorData":[{"id":"s","timestamp":"5000","dataChannels":[
        {"sensorChannelID":"x","values":[100,50]},{"sensorChannelID":"t","values":[0,20]}]}]},
    "inkData":{"strokes":[{"splineX":[1.5,2],"splineY":[3,4],"sensorDataID":"s","style":{"properties":
      {"red":{"value":1.0},"alpha":{"value":0.5},"size":{"value":2}},"brushURI":"x/Crayon","renderModeURI":"DESTINATION_OUT"}}]}})");
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_NEAR(out->sensors.at("s").x_px.at(1), 15, 1e-12);
  EXPECT_DOUBLE_EQ(out->sensors.at("s").time_s[1], 5.02);
  const UimStroke& stroke = out->strokes.at(0);
  EXPECT_EQ(stroke.x, (std::vector<double>{1.5, 2}));
  EXPECT_EQ(stroke.color, (log::Rgb{1, 0, 0}));
  EXPECT_DOUBLE_EQ(stroke.opacity, 0.5);
  EXPECT_DOUBLE_EQ(stroke.common_size, 2);
  EXPECT_EQ(stroke.sensor, "s");
  EXPECT_EQ(stroke.brush, BrushKind::kBristle);
  EXPECT_TRUE(stroke.erases);
}

}  // namespace
}  // namespace pentimento::sketch
