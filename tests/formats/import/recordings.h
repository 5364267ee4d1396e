#pragma once
// What the tests of all readers of recordings share: real files, counts, and what no file may do.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "formats/import/sketch/recording.h"

namespace pentimento::sketch {

/// The bytes of a file of tests/data/recordings.
inline std::string recording(const std::string& name) {
  std::ifstream file(std::string(PENTIMENTO_TEST_DATA) + "/recordings/" + name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Counts {
  int strokes = 0, samples = 0;
};
inline Counts counts_of(const Sketch& sketch) {
  Counts out;
  for (const Item& item : sketch.items) {
    const auto* stroke = std::get_if<Stroke>(&item);
    if (stroke == nullptr) continue;
    ++out.strokes;
    out.samples += static_cast<int>(stroke->samples.size());
  }
  return out;
}

/// What holds for every sketch that a reader lets through.
inline void expect_sound(const Sketch& sketch) {
  for (const Item& item : sketch.items) {
    const auto* stroke = std::get_if<Stroke>(&item);
    if (stroke == nullptr) continue;
    ASSERT_FALSE(stroke->samples.empty());
    EXPECT_TRUE(std::isfinite(stroke->width) && stroke->width >= 0) << stroke->width;
    EXPECT_TRUE(stroke->opacity >= 0 && stroke->opacity <= 1) << stroke->opacity;
    for (const double c : stroke->color) ASSERT_TRUE(c >= 0 && c <= 1) << c;
    double last_s = stroke->samples.front().time_s;
    for (const Sample& s : stroke->samples) {
      ASSERT_TRUE(std::isfinite(s.x) && std::isfinite(s.y) && std::isfinite(s.time_s));
      ASSERT_TRUE(!stroke->timed || s.time_s >= last_s);
      last_s = s.time_s;
      ASSERT_TRUE(!stroke->has_pressure || (s.pressure >= 0 && s.pressure <= 1)) << s.pressure;
      ASSERT_TRUE(!stroke->has_tilt ||
                  (std::abs(s.tilt_x_deg) <= 90 && std::abs(s.tilt_y_deg) <= 90));
    }
  }
}

/// Reads a file and expects a sound sketch, or an error of one line that names the file.
inline void expect_no_harm(const Format& format, const std::string& bytes,
                           const std::string& what) {
  const Result<Sketch> sketch = format.read({"in.bin", bytes}, {});
  if (sketch) return expect_sound(*sketch);
  EXPECT_TRUE(sketch.error().code == ErrorCode::kBadInput ||
              sketch.error().code == ErrorCode::kLimit)
      << what;
  EXPECT_TRUE(sketch.error().message.starts_with("in.bin:")) << what << sketch.error().message;
  EXPECT_EQ(sketch.error().message.find('\n'), std::string::npos) << what;
  EXPECT_LT(sketch.error().message.size(), 400u) << what;
}

/// Cut at every 1 % of the file, and `rounds` times with a few bytes changed.
inline void expect_no_harm_by_damage(std::string_view name, const std::string& bytes, int rounds) {
  const Format* format = find_format(name);
  ASSERT_NE(format, nullptr) << name;
  for (std::size_t percent = 0; percent < 100; ++percent)
    expect_no_harm(*format, bytes.substr(0, bytes.size() * percent / 100),
                   std::to_string(percent) + " %: ");
  std::mt19937 random(1);
  for (int round = 0; round < rounds; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 4 && !damaged.empty(); ++i)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    expect_no_harm(*format, damaged, "round " + std::to_string(round) + ": ");
  }
}

}  // namespace pentimento::sketch
