#include "replay/compare/flip_color.h"

#include <cmath>

namespace pentimento::flip {

namespace {

// Rec. 709 primaries with D65: rows X, Y, Z. The white point is the sum of each row.
constexpr double kXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

constexpr double white(int i) {
  return kXyz[i][0] + kXyz[i][1] + kXyz[i][2];
}

/// XYZ relative to white.
ColorTriple relative_xyz(const ColorTriple& rgb) {
  ColorTriple xyz{};
  for (std::size_t i = 0; i < 3; ++i)
    xyz[i] = (kXyz[i][0] * rgb[0] + kXyz[i][1] * rgb[1] + kXyz[i][2] * rgb[2]) /
             white(static_cast<int>(i));
  return xyz;
}

/// The inverse of relative_xyz, by Cramer's rule.
ColorTriple rgb_of_relative_xyz(const ColorTriple& xyz) {
  double m[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m[i][j] = kXyz[i][j] / white(i);
  const auto minor = [&m](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  ColorTriple rgb{};
  for (int j = 0; j < 3; ++j)
    rgb[static_cast<std::size_t>(j)] =
        (minor(0, j) * xyz[0] + minor(1, j) * xyz[1] + minor(2, j) * xyz[2]) / determinant;
  return rgb;
}

/// CIELAB's cube root with its straight start.
double lab_curve(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

ColorTriple ycxcz_of_rgb(const ColorTriple& rgb) {
  const ColorTriple t = relative_xyz(rgb);
  return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

ColorTriple rgb_of_ycxcz(const ColorTriple& ycc) {
  const double y = (ycc[0] + 16) / 116;
  return rgb_of_relative_xyz({y + ycc[1] / 500, y, y - ycc[2] / 200});
}

ColorTriple hunt_lab_of_rgb(const ColorTriple& rgb) {
  const ColorTriple t = relative_xyz(rgb);
  const double L = 116 * lab_curve(t[1]) - 16;
  const double a = 500 * (lab_curve(t[0]) - lab_curve(t[1]));
  const double b = 200 * (lab_curve(t[1]) - lab_curve(t[2]));
  return {L, 0.01 * L * a, 0.01 * L * b};
}

double hyab(const ColorTriple& a, const ColorTriple& b) {
  const double da = a[1] - b[1], db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace pentimento::flip
