#pragma once
// The uniforms of shaders/lamps.glsl.

#include <vector>

#include "core/canvas/canvas_state.h"
#include "core/optics/lighting.h"
#include "core/shading/gl/objects.h"

namespace pentimento {

/// The lamps that give light.
std::vector<Lamp> shining(const Lighting& lighting);

/// Sets the uniforms of shining lamps and of where cells lie, but for the tile's first cell.
void set_lamp_uniforms(const GlProgram& program, const CanvasGeometry& grid,
                       const Lighting& lighting);
/// Sets the tile's first cell, with which its window begins.
void set_first_cell(const GlProgram& program, int x, int y);

}  // namespace pentimento
