#pragma once
// The light lock on whole planes in double precision, for comparison with that of strips: one
// colour, every equation as it stands in core/shading/light_lock.h.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/field.h"

namespace pentimento::reference {

class PlainLightLock {
 public:
  /// `shown`: a colour of the picture; `wanted`: its light, a value per cell.
  PlainLightLock(const Field<float>& shown, const Field<float>& wanted)
      : shown_(shown), wanted_(wanted), gain_(wanted.width(), wanted.height(), 1.0) {
    for (int round = 0; round < 4; ++round) {
      const Field<double> found = cell_means();
      for_cells([&](int i, int j) {
        gain_(i, j) = std::clamp(gain_(i, j) * ratio(wanted_(i, j), found(i, j)), 0.6, 1 / 0.6);
      });
    }
    const Field<double> found = cell_means();
    for_cells([&](int i, int j) {
      double wanted_sum = 0, found_sum = 0;
      for (int n = -1; n <= 1; ++n) {
        for (int m = -1; m <= 1; ++m) {
          wanted_sum += nearest(wanted_, i + m, j + n);
          found_sum += nearest(found, i + m, j + n);
        }
      }
      gain_(i, j) *= ratio(wanted_sum / 9, found_sum / 9);
    });
  }

  double pixel(int x, int y) const { return static_cast<double>(shown_(x, y)) * gain_at(x, y); }

 private:
  template <typename Body>
  void for_cells(const Body& body) const {
    for (int j = 0; j < wanted_.height(); ++j)
      for (int i = 0; i < wanted_.width(); ++i) body(i, j);
  }
  template <typename T>
  static double nearest(const Field<T>& f, int i, int j) {
    return static_cast<double>(
        f(std::clamp(i, 0, f.width() - 1), std::clamp(j, 0, f.height() - 1)));
  }
  static double ratio(double wanted, double found) {
    return std::clamp((wanted + 0.002) / (found + 0.002), 0.5, 2.0);
  }
  /// Of a pixel's centre, in cells.
  double across(int x) const { return (x + 0.5) * wanted_.width() / shown_.width(); }
  double down(int y) const { return (y + 0.5) * wanted_.height() / shown_.height(); }
  /// Quadratic B-spline of a cell whose centre lies `t` cells away.
  static double spline(double t) {
    const double a = std::abs(t);
    return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
  }
  double gain_at(int x, int y) const {
    const double u = across(x), v = down(y);
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    double sum = 0;
    for (int n = j - 1; n <= j + 1; ++n)
      for (int m = i - 1; m <= i + 1; ++m)
        sum += spline(u - m - 0.5) * spline(v - n - 0.5) * nearest(gain_, m, n);
    return sum;
  }
  Field<double> cell_means() const {
    Field<double> sum(wanted_.width(), wanted_.height()), count(wanted_.width(), wanted_.height());
    for (int y = 0; y < shown_.height(); ++y) {
      for (int x = 0; x < shown_.width(); ++x) {
        const int i = static_cast<int>(across(x)), j = static_cast<int>(down(y));
        sum(i, j) += pixel(x, y);
        count(i, j) += 1;
      }
    }
    for_cells([&](int i, int j) { sum(i, j) /= count(i, j); });
    return sum;
  }

  const Field<float>& shown_;
  const Field<float>& wanted_;
  Field<double> gain_;
};

}  // namespace pentimento::reference
