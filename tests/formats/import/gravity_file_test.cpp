#include "formats/import/gravity_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace pentimento::sketch {
namespace {

Result<GravityRecording> read(std::string_view text, const GravityOptions& options = {}) {
  return read_gravity({"g.csv", text}, options);
}
std::string sensor_file(const std::string& name) {
  std::ifstream file(std::string(PENTIMENTO_TEST_DATA) + "/gravity/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}
log::Gravity reading(const Result<GravityRecording>& found, std::size_t i) {
  return std::get<log::Gravity>(found->readings.at(i).action);
}

// Lying face up a phone of Apple's reads z = -1; the log has +9.81.
TEST(GravityFile, ReadsAnIphoneThatLiesFlat) {
  const auto found = read(sensor_file("iphone_flat.csv"));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->kind, "coremotion");
  EXPECT_EQ(found->readings.size(), 399u);
  for (std::size_t i = 0; i < found->readings.size(); ++i) {
    EXPECT_NEAR(reading(found, i).z_m_s2, 9.80665, 0.01);
    EXPECT_NEAR(reading(found, i).x_m_s2, 0, 0.2);
  }
  EXPECT_NEAR(static_cast<double>(found->readings[1].time_us), 1e4, 100);
}

// Picked up into a pocket: its upper edge points down, (0, -1, 0) becomes y = -9.81.
TEST(GravityFile, ReadsAnIphoneThatIsPickedUp) {
  const auto found = read(sensor_file("iphone_balance.csv"));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(reading(found, 1).y_m_s2, -0.946251 * 9.80665, 1e-4);
  for (std::size_t i = 0; i < found->readings.size(); ++i) {
    const log::Gravity g = reading(found, i);
    EXPECT_NEAR(std::hypot(g.x_m_s2, g.y_m_s2, g.z_m_s2), 9.80665, 1e-3);
  }
}

TEST(GravityFile, ReadsAndroidsTablesInNanoseconds) {
  const auto found = read("timestamp,x,y,z\n8000000000,0,9.81,0.1\n8020000000,1,9.7,0\n");
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->kind, "android");
  EXPECT_EQ(found->readings[1].time_us, 20000);
  EXPECT_EQ(reading(found, 0).y_m_s2, 9.81);
}

TEST(GravityFile, ReadsDeviceMotionEvents) {
  const std::string_view line =
      R"({"timeStamp":1000,"accelerationIncludingGravity":{"x":0.5,"y":1,"z":9.75}})";
  const std::string list =
      "[" + std::string(line) + "," +
      R"({"timeStamp":1016,"accelerationIncludingGravity":{"x":0,"y":1,"z":9}}])";
  for (const std::string& text : {std::string(line) + "\n", list}) {
    const auto found = read(text);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->kind, "devicemotion");
    EXPECT_EQ(reading(found, 0).z_m_s2, 9.75);
  }
  EXPECT_EQ(read(list)->readings[1].time_us, 16000);
  EXPECT_EQ(reading(read(line, {"devicemotion-ios", 0}), 0).z_m_s2, -9.75);
}

TEST(GravityFile, TurnsWithTheScreen) {
  const auto turned = [](int deg) { return reading(read("t,x,y,z\n0,1,2,9\n", {"", deg}), 0); };
  EXPECT_EQ(turned(0).x_m_s2, 1);
  EXPECT_EQ(turned(90).x_m_s2, -2);
  EXPECT_EQ(turned(90).y_m_s2, 1);
  EXPECT_EQ(turned(180).x_m_s2, -1);
  EXPECT_EQ(turned(180).y_m_s2, -2);
  EXPECT_EQ(turned(270).x_m_s2, 2);
  EXPECT_EQ(turned(270).y_m_s2, -1);
  for (const int deg : {0, 90, 180, 270}) EXPECT_EQ(turned(deg).z_m_s2, 9);
}

TEST(GravityFile, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> bad[] = {
      {"a,b\n1,2\n", "g.csv:1: no columns of time and gravity, as t_s,grav_x_g,grav_y_g,grav_z_g"},
      {"t,x,y,z\n0,1,2\n", "g.csv:2: 3 columns, the first line has 4"},
      {"t,x,y,z\n0,1,nan,2\n", "g.csv:2: 'nan' is not a number"},
      {"t,x,y,z\n0,1,2,2e3\n", "g.csv:1: gravity 2000 m/s^2 of reading 1 is too large"},
      {"t,x,y,z\n1,1,2,2\n0,1,2,2\n", "g.csv:2: time of reading 2 runs back or is too large"},
      {"t,x,y,z\n", "g.csv:1: no reading"},
      {"{\"timeStamp\":1}\n", "g.csv:1: accelerationIncludingGravity.x is missing"},
      {"{\"x\n", "g.csv:1: not valid JSON"}};
  for (const auto& [text, message] : bad) {
    const auto found = read(text);
    ASSERT_FALSE(found) << text;
    EXPECT_EQ(found.error().message, message);
  }
}

}  // namespace
}  // namespace pentimento::sketch
