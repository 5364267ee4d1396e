#pragma once
// Occlusion: what the relief leaves of sky and lamps in each cell of a tile's window. It is found
// by a search for the horizon along lines of cells, before the tile is shaded. The search runs on
// the processor, which reads rows of neighbours in order; a shader would read them one by one.

#include <array>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/optics/lighting.h"

namespace pentimento {

/// How far the search looks. Ridges of paint are a millimetre or two high.
inline constexpr float kHorizonRadius_m = 0.006f;
inline constexpr int kMostHorizonRadius_cells = 64;
inline constexpr int kSkyDirections = 8;

/// Cells of relief needed on every side: the reach on the axis with the smaller cells, and one for
/// the interpolation across the line.
int horizon_border(const CanvasGeometry& grid);

struct HorizonLines {
  std::vector<std::array<float, 3>> sky;  // kSkyDirections times as many: right, down, 1 / distance
  std::vector<float> shadow;              // cells along the longer axis
};
/// The distances at which the search looks. They grow by about 2 for the sky, and by about 1.4 for
/// lamps, whose shadows have edges. They are at most 64 cells, and the same for every cell of the
/// grid.
HorizonLines horizon_lines(const CanvasGeometry& grid);

/// How many RGBA planes the result takes for so many shining lamps: one value for the sky, then one
/// for each lamp.
constexpr int horizon_planes(int lamps) {
  return (lamps + 4) / 4;
}

class HorizonSearch {
 public:
  HorizonSearch(const CanvasGeometry& grid, const Lighting& lighting, const Threads& threads);

  /// `relief`: two floats a cell, the first its height (m), of `window` and horizon_border() cells
  /// around it. Gives the texels of each plane, packed; 0..1.
  const std::vector<std::vector<float>>& search(const std::vector<float>& relief,
                                                const CellWindow& window);

 private:
  CanvasGeometry grid_;
  std::vector<Lamp> lamps_;
  float relief_scale_;
  const Threads& threads_;
  HorizonLines lines_;
  int border_;
  std::vector<float> height_;  // of the window and its border, times the relief's scale
  std::vector<std::vector<float>> planes_;
};

}  // namespace pentimento
