#pragma once
// The GLSL program for one kind of canvas and request: which code is compiled in, and its uniforms.

#include <array>
#include <string>

#include "core/canvas/canvas_state.h"
#include "core/optics/lighting.h"
#include "core/shading/aov.h"
#include "core/shading/gl/objects.h"
#include "core/shading/horizon.h"

namespace pentimento {

/// What the program is compiled for. Equal variants share a program.
struct ShadeVariant {
  int channels = 1;
  int samples_per_pixel = 1;
  bool interpolate = false;
  int relief_samples =
      1;  // slopes per cell, along each axis: 1, or 2 where nothing is interpolated
  bool reflection_map = false;
  bool probe = false;  // the gloss shows a light probe
  int lamps = 1;       // that shine
  bool occlusion = false;
  /// Where each kind's first target is; -1 = not drawn.
  std::array<int, 7> target = {0, -1, -1, -1, -1, -1, -1};
  int targets = 1;

  /// Whether the slopes are found before, cell by cell (cell_slopes.h).
  bool slopes_ready() const { return !interpolate && relief_samples == 1; }
  /// RGBA texels of what the relief leaves of sky and lamps.
  int occlusion_planes() const { return occlusion ? horizon_planes(lamps) : 0; }
  /// RGBA texels of the channels.
  int planes() const { return (channels + 3) / 4; }
  /// How many of these planes are uploaded: all if pigments are drawn, else none.
  int amount_planes() const { return target.back() < 0 ? 0 : planes(); }
  bool operator<(const ShadeVariant& other) const { return defines() < other.defines(); }
  std::string defines() const;
};

/// Gives each kind that `planes` needs its targets, in the order of TargetKind.
void assign_targets(const std::vector<PlaneSource>& planes, ShadeVariant& variant);

/// Which texture unit each sampler reads.
enum ShadeUnit {
  kColumns,
  kRows,
  kGround,
  kRelief,
  kSlopes,
  kAmounts,
  kReflectionMap,
  kSeenFirst,
  kSeenSecond,
  kGloss
};

inline constexpr const char* kGlslVersion = "#version 330 core\n";

Result<GlProgram> link_shade_program(const GlFunctions& gl, const ShadeVariant& variant);

/// Relief scale over the cell's sizes, 1/m: what a difference of heights between cells is
/// multiplied by.
std::array<float, 2> relief_per_cell(const Lighting& lighting, const CanvasGeometry& grid);

/// What the uniforms of a picture are set from.
struct ShadeParameters {
  const Lighting& lighting;
  const CanvasGeometry& grid;
  int relief_border = 0;  // cells
};
/// Sets all uniforms but the tile's first cell; the program must be in use.
void set_shade_uniforms(const GlProgram& program, const ShadeParameters& parameters);

}  // namespace pentimento
