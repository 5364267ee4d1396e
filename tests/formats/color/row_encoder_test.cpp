#include "formats/color/row_encoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "formats/color/dither.h"

namespace pentimento {
namespace {

LinearRgb to_float(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/// The plain twin: a pixel by itself.
class PlainEncoder {
 public:
  PlainEncoder(const ColorEncoding& encoding, int bit_depth)
      : encoding_(encoding),
        dithers_(encoding.dither && bit_depth == 8),
        wide_(bit_depth == 16),
        encoder_(encoding.profile, dithers_ || wide_ ? 65535 : 255) {}

  std::vector<std::uint8_t> pixel(const LinearRgb& light, int x, int y) const {
    const LinearRgb weights = to_float(to_xyz(encoding_.profile)[1]);
    LinearRgb c = light;
    if (encoding_.profile != ColorProfile::kSrgb) {
      const ColorMatrix m = between(ColorProfile::kSrgb, encoding_.profile);
      for (std::size_t i = 0; i < 3; ++i) {
        const LinearRgb row = to_float(m[i]);
        c[i] = (row[0] * light[0] + row[1] * light[1]) + row[2] * light[2];
      }
    }
    c = into_gamut(c, weights);
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 3; ++i) {
      int code = encoder_.encode(c[static_cast<std::size_t>(i)]);
      if (dithers_) code = dithered_code(code, x + encoding_.left, y + encoding_.top, i);
      if (wide_) bytes.push_back(static_cast<std::uint8_t>(code >> 8));
      bytes.push_back(static_cast<std::uint8_t>(code));
    }
    return bytes;
  }

 private:
  ColorEncoding encoding_;
  bool dithers_, wide_;
  CodeEncoder encoder_;
};

struct Light {
  std::vector<float> r, g, b;
  RgbRow row() const { return {r.data(), g.data(), b.data()}; }
};

/// Light of all kinds: dark and bright, and here and there beyond what the profile can show.
Light some_light(int width) {
  Light light;
  std::uint64_t n = 0;
  const auto next = [&](float largest) {
    const float u = random_uniform(RandomPurpose::kStampJitter, 7, n++);
    return largest * u * u * u;
  };
  for (int x = 0; x < width; ++x) {
    const float largest = x % 50 == 49 ? 3.0f : 1.0f;
    light.r.push_back(x % 70 == 69 ? -next(0.1f) : next(largest));
    light.g.push_back(next(largest));
    light.b.push_back(x % 31 == 30 ? 0.0f : x % 31 == 29 ? 1.0f : next(largest));
  }
  return light;
}

TEST(RowEncoder, EqualsItsTwin) {
  for (const ColorProfile profile : kColorProfiles)
    for (const int bit_depth : {8, 16})
      for (const bool dither : {false, true})
        for (const int width : {1, 2, 63, 64, 65, 127, 1000}) {
          const ColorEncoding encoding{profile, dither, 5, 1000};
          const Light light = some_light(width);
          const int bytes = bit_depth == 16 ? 6 : 3;
          std::vector<std::uint8_t> row(static_cast<std::size_t>(width * bytes));
          ASSERT_TRUE(RowEncoder(encoding, bit_depth).encode(light.row(), width, 17, row.data()));
          const PlainEncoder twin(encoding, bit_depth);
          for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const auto first = row.begin() + x * bytes;
            ASSERT_EQ(std::vector<std::uint8_t>(first, first + bytes),
                      twin.pixel({light.r[i], light.g[i], light.b[i]}, x, 17))
                << x << " of " << width << ", " << bit_depth << " bits";
          }
        }
}

TEST(RowEncoder, SaysThatAValueIsNoNumber) {
  const RowEncoder encoder({ColorProfile::kSrgb, true}, 8);
  std::vector<std::uint8_t> row(300);
  for (const std::size_t x : {0U, 63U, 64U, 99U})
    for (std::vector<float> Light::*plane : {&Light::r, &Light::g, &Light::b}) {
      Light light = some_light(100);
      (light.*plane)[x] = std::numeric_limits<float>::quiet_NaN();
      EXPECT_FALSE(encoder.encode(light.row(), 100, 3, row.data())) << x;
      (light.*plane)[x] = std::numeric_limits<float>::infinity();
      EXPECT_TRUE(encoder.encode(light.row(), 100, 3, row.data())) << x;
    }
}

}  // namespace
}  // namespace pentimento
