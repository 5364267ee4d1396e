#include "core/shading/lamp_uniforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/optics/microfacet.h"

namespace pentimento {

std::vector<Lamp> shining(const Lighting& lighting) {
  std::vector<Lamp> out;
  std::copy_if(lighting.lamps.begin(), lighting.lamps.end(), std::back_inserter(out),
               [](const Lamp& lamp) { return lamp.intensity > 0; });
  return out;
}

void set_lamp_uniforms(const GlProgram& program, const CanvasGeometry& grid,
                       const Lighting& lighting) {
  std::vector<std::array<float, 3>> place, radiance, facets;
  std::vector<std::array<float, 2>> mirror;
  const double index = static_cast<double>(lighting.refractive_index);
  std::vector<float> range2;
  for (const Lamp& lamp : shining(lighting)) {
    place.push_back(lamp.position_m.value_or(lamp.direction));
    const auto [x, y, z] = place.back();
    const double size = std::sqrt(x * x + y * y + (z + 1.0) * (z + 1.0));
    const bool behind = size < 1e-3;
    const auto unit = [&](double v) { return behind ? 0.0f : static_cast<float>(v / size); };
    facets.push_back({unit(x), unit(y), unit(z + 1.0)});
    mirror.push_back({behind ? 1.0f : static_cast<float>(2 / size),
                      behind ? 0.0f : static_cast<float>(fresnel(std::min(size / 2, 1.0), index))});
    range2.push_back(lamp.position_m ? x * x + y * y + z * z : 0);
    radiance.push_back({lamp.intensity * lamp.color[0], lamp.intensity * lamp.color[1],
                        lamp.intensity * lamp.color[2]});
  }
  const int n = static_cast<int>(place.size());
  if (n > 0) {
    program.set_vec3("lamp_place", place[0].data(), n);
    program.set_vec3("lamp_radiance", radiance[0].data(), n);
    program.set_floats("lamp_range2", range2.data(), n);
    program.set_vec3("lamp_facets", facets[0].data(), n);
    program.set_vec2("lamp_mirror", mirror[0].data(), n);
  }
  const std::array<float, 2> cell = {grid.dx_m(), grid.dy_m()};
  const std::array<float, 2> half = {static_cast<float>(grid.width_m / 2),
                                     static_cast<float>(grid.height_m / 2)};
  program.set_vec2("cell_m", cell.data());
  program.set_vec2("half_canvas_m", half.data());
}

void set_first_cell(const GlProgram& program, int x, int y) {
  const std::array<float, 2> first = {static_cast<float>(x), static_cast<float>(y)};
  program.set_vec2("first_cell", first.data());
}

}  // namespace pentimento
