#include "core/shading/area_filter.h"

#include <gtest/gtest.h>

#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

/// Columns and rows of a picture that is `from` pixels a side, in strips of `height` rows.
reference::WholePicture reduced(int from, int to, int x0, int columns, int y0, int rows, int height,
                                const std::vector<std::string>& names = {"R"}) {
  const AreaAxis axis{from, to};
  reference::WholePicture out;
  AreaFilter filter(axis, x0, columns, axis, y0, rows, {&out});
  const int left = axis.first_source(x0), right = axis.last_source(x0, columns);
  const int top = axis.first_source(y0), bottom = axis.last_source(y0, rows);
  for (int y = top; y <= bottom; y += height) {
    PictureStrip strip{y - top, std::min(height, bottom + 1 - y), names, {}};
    std::vector<Field<float>> planes;
    for (std::size_t p = 0; p < names.size(); ++p) {
      planes.emplace_back(right + 1 - left, strip.rows);
      for (int j = 0; j < strip.rows; ++j)
        for (int i = left; i <= right; ++i)
          planes[p](i - left, j) = static_cast<float>((i * 31 + (y + j) * 17) % 23 + 1);
    }
    for (const Field<float>& plane : planes) strip.plane.push_back(plane.view());
    EXPECT_TRUE(filter.write(strip));
  }
  return out;
}

TEST(AreaFilter, ThreeBecomeTwoByTheirShares) {
  // Pixels 0..2 of a row are 1, 9, 17 (mod 23 of 31 i + 1); thirds go to the border's neighbours:
  // (1 + 9/2) / 1.5 and (9/2 + 17) / 1.5 in row 0; rows are weighed alike.
  const auto p = reduced(3, 2, 0, 2, 0, 2, 3);
  const double v[3][3] = {{1, 9, 17}, {18, 3, 11}, {12, 20, 5}};
  const auto mean = [&](int x, int y) {
    const double wx[2][3] = {{2 / 3.0, 1 / 3.0, 0}, {0, 1 / 3.0, 2 / 3.0}};
    double sum = 0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) sum += wx[x][i] * wx[y][j] * v[j][i];
    return sum;
  };
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) EXPECT_NEAR(p.at("R", x, y), mean(x, y), 1e-5) << x << y;
}

TEST(AreaFilter, KeepsTheSumOfLight) {
  const auto all = reduced(301, 170, 0, 170, 0, 170, 64);
  double sum = 0, expected = 0;
  for (const float v : all.planes.at("R")) sum += static_cast<double>(v);
  for (int y = 0; y < 301; ++y)
    for (int x = 0; x < 301; ++x) expected += (x * 31 + y * 17) % 23 + 1;
  // Weights are floats, 2^-24 each.
  EXPECT_NEAR(sum / (170 * 170), expected / (301 * 301), 1e-6 * 12);
}

TEST(AreaFilter, DoesNotDependOnStripsOrCrop) {
  const auto whole = reduced(301, 270, 0, 270, 0, 270, 301);
  EXPECT_EQ(reduced(301, 270, 0, 270, 0, 270, 1).planes, whole.planes);
  const auto part = reduced(301, 270, 33, 50, 101, 140, 7);
  EXPECT_TRUE(part.in_order);
  ASSERT_EQ(part.rows, 140);
  for (int y = 0; y < 140; ++y)
    for (int x = 0; x < 50; ++x) ASSERT_EQ(part.at("R", x, y), whole.at("R", x + 33, y + 101));
}

TEST(AreaFilter, AxesOfVectorsStayUnitVectors) {
  const auto p = reduced(7, 4, 0, 4, 0, 4, 3, {"R", "normal.X", "normal.Y", "normal.Z"});
  for (int i = 0; i < 4; ++i) {
    const float x = p.at("normal.X", i, i), y = p.at("normal.Y", i, i), z = p.at("normal.Z", i, i);
    EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-6);  // a few roundings
  }
  EXPECT_GT(p.at("R", 1, 1), 1);
}

}  // namespace
}  // namespace pentimento
