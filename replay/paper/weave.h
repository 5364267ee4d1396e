#pragma once
// A plain weave, one thread over, one under: the height of woven cloth in 0..1 as a periodic
// function of the unit square. It reaches the state, so it uses core's own arithmetic only.

#include <span>
#include <vector>

namespace pentimento {

struct WeaveShape {
  int threads = 16;         // across one repeat, each way; even, so that the repeat closes
  double unevenness = 0.0;  // 0..1: how much threads differ in thickness
};

/// How the unit square lies on a grid.
struct RepeatGrid {
  int width = 0;
  int height = 0;
  double cells_per_repeat_x = 1;
  double cells_per_repeat_y = 1;
};

/// Means over cells, 0..1. With p(u) = sin^2(pi n u) the profile of a thread, s(u) = sin(pi n u)
/// its going over and under, and q its thickness:
///   height(u, v) = [q p(u) (1 + s(v) c(u)) + q p(v) (1 - s(u) c(v))] / 2, c = +-1 by thread
/// Every term is a product of a function of u and one of v, so cell means are products of means
/// along a row and along a column, taken with kMeanSamples midpoints per thread or more.
class Weave {
 public:
  Weave(const WeaveShape& shape, const RepeatGrid& grid);
  /// Height of the cells [x, x + out.size()) of row y.
  void row(int x, int y, std::span<float> out) const;

 private:
  /// Along one axis: `body` is how far a thread of this direction stands out, `sway` the same with
  /// the sign of the thread, `wave` how the threads across it go over and under.
  struct Profile {
    double body = 0, sway = 0, wave = 0;
  };
  enum class Side { kWarp, kWeft };
  static Profile profile_at(const WeaveShape& shape, Side side, double u);
  /// Mean profile of each cell along an axis, number by number.
  struct CellMeans {
    std::vector<double> body, sway, wave;
  };
  static CellMeans cell_means(const WeaveShape& shape, Side side, int cells,
                              double cells_per_repeat);
  CellMeans columns_, rows_;
};

}  // namespace pentimento
