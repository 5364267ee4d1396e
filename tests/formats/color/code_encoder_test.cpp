#include "formats/color/code_encoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pentimento {
namespace {

class CodeEncoderOf : public testing::TestWithParam<ColorProfile> {
 protected:
  double light(double v) const { return decode_transfer(GetParam(), v); }
};
INSTANTIATE_TEST_SUITE_P(Profiles, CodeEncoderOf, testing::ValuesIn(kColorProfiles));

TEST_P(CodeEncoderOf, EveryCodeComesBack) {
  for (const int max : {255, 65535}) {
    const CodeEncoder encoder(GetParam(), max);
    for (int c = 0; c <= max; ++c)
      ASSERT_EQ(encoder.encode(static_cast<float>(light(static_cast<double>(c) / max))), c);
  }
}

TEST_P(CodeEncoderOf, RoundsAtTheMiddleBetweenCodes) {
  for (const int max : {255, 65535}) {
    const CodeEncoder encoder(GetParam(), max);
    for (int c = 0; c < max; ++c) {
      const double edge = light((c + 0.5) / max);
      // The nearest floats on both sides of the edge.
      float above = static_cast<float>(edge);
      if (static_cast<double>(above) < edge) above = std::nextafter(above, 2.0f);
      ASSERT_EQ(encoder.encode(above), c + 1);
      ASSERT_EQ(encoder.encode(std::nextafter(above, 0.0f)), c);
    }
  }
}

TEST_P(CodeEncoderOf, ClampsWhatLiesOutside) {
  const CodeEncoder encoder(GetParam(), 65535);
  EXPECT_EQ(encoder.encode(-1.0f), 0);
  EXPECT_EQ(encoder.encode(-0.0f), 0);
  EXPECT_EQ(encoder.encode(1e-30f), 0);
  EXPECT_EQ(encoder.encode(static_cast<float>(light(0.49 / 65535))), 0);
  EXPECT_EQ(encoder.encode(static_cast<float>(light(0.51 / 65535))), 1);
  EXPECT_EQ(encoder.encode(1.0f), 65535);
  EXPECT_EQ(encoder.encode(INFINITY), 65535);
}

TEST_P(CodeEncoderOf, ARowIsEncodedAsItsValuesAre) {
  for (const int max : {255, 65535}) {
    const CodeEncoder encoder(GetParam(), max);
    // Both sides of every edge between codes, the ends, and what lies beyond them.
    std::vector<float> values = {-1,     -0.0f, 0,    1e-42f,   1e-30f,
                                 1e-12f, 1,     1.5f, INFINITY, -INFINITY};
    for (int c = 0; c < max; ++c) {
      const auto edge = static_cast<float>(light((c + 0.5) / max));
      for (const float v : {std::nextafter(edge, 0.0f), edge, std::nextafter(edge, 2.0f)})
        values.push_back(v);
    }
    for (const std::size_t together : {1U, 3U, 64U, 1000U})
      for (std::size_t i = 0; i < values.size(); i += together) {
        const std::size_t n = std::min(together, values.size() - i);
        std::vector<int> code(n);
        encoder.encode_row(&values[i], static_cast<int>(n), code.data());
        for (std::size_t k = 0; k < n; ++k)
          ASSERT_EQ(code[k], encoder.encode(values[i + k])) << values[i + k];
      }
  }
}

}  // namespace
}  // namespace pentimento
