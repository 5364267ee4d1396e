#pragma once
// The pass before shading: what the relief leaves of sky and lamps in each cell of a tile's window
// (shaders/horizon.frag.glsl), and the lines of cells along which it looks.

#include <array>
#include <vector>

#include "core/canvas_state.h"
#include "core/shading/shade_program.h"

namespace pentimento {

/// How far it looks: ridges of paint are a millimetre or two high.
inline constexpr float kHorizonReach_m = 0.006f;
inline constexpr int kMostReach_cells = 64;
inline constexpr int kSkyDirections = 8;
inline constexpr int kMostSteps = 16;  // along a line

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

Result<GlProgram> link_horizon_program(const GlFunctions& gl, const ShadeVariant& variant);
/// Sets all uniforms but the tile's; the program must be in use.
void set_horizon_uniforms(const GlProgram& program, const CanvasGeometry& grid,
                          const Lighting& lighting);

}  // namespace pentimento
