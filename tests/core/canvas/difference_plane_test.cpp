#include "core/canvas/difference_plane.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/core/base/resident_memory.h"

namespace pentimento {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(DifferencePlane, IsWhatIsKnownAtFirst) {
  const DifferencePlane plane(5, 3);
  const std::array<float, 3> known = {1, -0.0f, 1e-30f};
  std::array<float, 3> out{};
  plane.read(2, 1, known, out);
  EXPECT_EQ(out, known);
  EXPECT_TRUE(std::signbit(out[1]));
}

TEST(DifferencePlane, BringsBackEveryBit) {
  DifferencePlane plane(6, 2);
  const std::vector<float> known = {0.3f, 0.3f, 0, kNan, -0.0f, kInfinity};
  const std::vector<float> values = {0.3f, kNan, -0.0f, 1, 0, 1e-42f};
  plane.write(0, 1, known, values);
  std::vector<float> out(6);
  plane.read(0, 1, known, out);
  for (std::size_t x = 0; x < 6; ++x) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(out[x]), std::bit_cast<std::uint32_t>(values[x])) << x;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(plane.at(static_cast<int>(x), 1, known[x])),
              std::bit_cast<std::uint32_t>(values[x]));
  }
  plane.read(0, 0, known, out);  // the other row
  EXPECT_EQ(std::bit_cast<std::uint32_t>(out[0]), std::bit_cast<std::uint32_t>(0.3f));
  const DifferencePlane copy = plane.clone();
  plane.set(1, 1, 0.3f, 7);
  EXPECT_EQ(plane.at(1, 1, 0.3f), 7);
  EXPECT_TRUE(std::isnan(copy.at(1, 1, 0.3f)));
}

TEST(DifferencePlane, TakesNoMemoryForWhatIsKnown) {
  if (is_marked_when_given()) GTEST_SKIP();
  constexpr int kSide = 8192;  // a plane of 256 MiB
  const long before_mib = resident_mib();
  DifferencePlane plane(kSide, kSide);
  const std::vector<float> known(kSide, 0.7f);
  for (int y = 0; y < kSide; ++y) plane.write(0, y, known, known);
  EXPECT_LT(resident_mib() - before_mib, 80 + taken_by_reading_mib(256));
}

}  // namespace
}  // namespace pentimento
