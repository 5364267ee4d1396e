#include "core/shading/horizon.h"

#include <algorithm>
#include <cmath>

#include "core/shading/lamp_uniforms.h"
#include "core/shading/shader_source.h"

namespace pentimento {
namespace {

constexpr double kPi = 3.14159265358979323846;

int reach_cells(const CanvasGeometry& grid) {
  const double smaller = std::min(grid.width_m / grid.width, grid.height_m / grid.height);
  const double cells = std::ceil(static_cast<double>(kHorizonReach_m) / smaller);
  return static_cast<int>(std::clamp(cells, 2.0, static_cast<double>(kMostReach_cells)));
}

/// 1, ... up to `last`, each about `ratio` times the one before.
std::vector<int> growing(double ratio, int last) {
  std::vector<int> out;
  for (double at = 1; at < last; at *= ratio) {
    const int whole = static_cast<int>(std::lround(at));
    if (out.empty() || out.back() != whole) out.push_back(whole);
  }
  if (out.empty() || out.back() < last) out.push_back(last);
  return out;
}

}  // namespace

int horizon_border(const CanvasGeometry& grid) {
  return reach_cells(grid) + 1;
}

HorizonLines horizon_lines(const CanvasGeometry& grid) {
  const double dx = grid.width_m / grid.width, dy = grid.height_m / grid.height;
  const double cell = std::min(dx, dy);
  HorizonLines lines;
  for (int d = 0; d < kSkyDirections; ++d) {
    const double angle = 2 * kPi * (d + 0.5) / kSkyDirections;
    for (const int n : growing(2, reach_cells(grid))) {
      double right = std::round(n * cell * std::cos(angle) / dx);
      double down = std::round(n * cell * std::sin(angle) / dy);
      // Long cells: the nearest in this direction, along their shorter side at least.
      if (right == 0 && down == 0) (dx < dy ? right : down) = 1;
      const double distance = std::sqrt(right * dx * right * dx + down * dy * down * dy);
      lines.sky.push_back(
          {static_cast<float>(right), static_cast<float>(down), static_cast<float>(1 / distance)});
    }
  }
  for (const int n : growing(1.4, reach_cells(grid))) lines.shadow.push_back(static_cast<float>(n));
  return lines;
}

Result<GlProgram> link_horizon_program(const GlFunctions& gl, const ShadeVariant& variant) {
  const std::string version = kGlslVersion;
  return GlProgram::link(gl, version + std::string(shader_source("triangle.vert.glsl")),
                         version + variant.defines() + std::string(shader_source("lamps.glsl")) +
                             std::string(shader_source("horizon.frag.glsl")));
}

void set_horizon_uniforms(const GlProgram& program, const CanvasGeometry& grid,
                          const Lighting& lighting) {
  const HorizonLines lines = horizon_lines(grid);
  const int border = horizon_border(grid);
  program.set("relief", static_cast<int>(kRelief));
  program.set("relief_border", border);
  program.set("relief_scale", lighting.relief_scale);
  program.set("sky_directions", kSkyDirections);
  program.set("sky_steps", static_cast<int>(lines.sky.size()) / kSkyDirections);
  program.set("shadow_steps", static_cast<int>(lines.shadow.size()));
  program.set_vec3("sky_step", lines.sky[0].data(), static_cast<int>(lines.sky.size()));
  program.set_floats("shadow_step", lines.shadow.data(), static_cast<int>(lines.shadow.size()));
  set_lamp_uniforms(program, grid, lighting);
}

}  // namespace pentimento
