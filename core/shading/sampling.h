#pragma once
// Where the samples of a picture lie among the cells of the canvas, along one axis (A38). They are
// computed from the position in the whole picture, so that the numbers do not depend on the tile.

#include <vector>

namespace pentimento {

/// One axis of picture and grid: both cover the canvas from edge to edge.
struct SampleAxis {
  int cells = 1;
  int pixels = 1;
  int per_pixel = 1;  // samples a pixel; more than one when pixels are larger than cells

  /// Every sample lies on a cell's centre: nothing is interpolated.
  bool on_cells() const { return cells == pixels * per_pixel; }
  /// Cells that a run of `count` pixels needs at most, borders included.
  int most_cells(int count) const;
};

/// Samples per pixel, along each axis, that leave no cell unseen.
int samples_per_pixel(int cells, int pixels);

/// Cells along a pixel that the shader reads at most: more would make one pixel a tile of its own.
inline constexpr int kMostCellsOfPixel = 2048;

/// Whether a picture is drawn cell by cell, and the cells' light averaged: it is smaller than the
/// canvas, and either not by a whole factor or by more than kMostCellsOfPixel. By a whole factor
/// the shader itself does the same.
bool averages_cells(int cells_x, int cells_y, int pixels_x, int pixels_y);

/// What the samples of a run of pixels need.
struct AxisWindow {
  int first_cell = 0;  // may be negative: cells outside the grid repeat its edge
  int cells = 0;
  std::vector<float> table;  // per sample: cell before it, counted from first_cell; fraction onward
};
/// Cells of a window before its first sample's own. So where samples lie on cells, sample s of a
/// run has the window's cell kCellsBefore + s.
inline constexpr int kCellsBefore = 2;

/// Cubic interpolation between cells needs one cell before and two after each sample's own; slopes
/// within a cell need two before it.
AxisWindow axis_window(const SampleAxis& axis, int first_pixel, int count);

}  // namespace pentimento
