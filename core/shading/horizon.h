#pragma once
// What the relief leaves of sky and lamps in each cell of a tile's window, by a search for the
// horizon along lines of cells, before the tile is shaded. On the processor: its rows of neighbours
// are read in order here, one by one in a shader.

#include <array>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/optics/lighting.h"

namespace pentimento {

/// How far it looks: ridges of paint are a millimetre or two high.
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
/// Distances grow about by 2 for the sky and by 1.4 for lamps, whose shadows have edges; at most 64
/// cells, and the same for every cell of the grid.
HorizonLines horizon_lines(const CanvasGeometry& grid);

/// RGBA texels of what is seen with so many lamps that shine: the sky, then each.
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
