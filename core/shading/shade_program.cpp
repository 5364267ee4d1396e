#include "core/shading/shade_program.h"

#include <cmath>

#include "core/optics/gloss_table.h"
#include "core/optics/microfacet.h"
#include "core/optics/tone.h"
#include "core/shading/lamp_uniforms.h"
#include "core/shading/sampling.h"
#include "core/shading/shader_source.h"

namespace pentimento {
namespace {

constexpr const char* kTargetDefine[] = {"PICTURE_TARGET", "ALBEDO_TARGET",   "NORMAL_TARGET",
                                         "DIFFUSE_TARGET", "SPECULAR_TARGET", "REFLECTION_TARGET",
                                         "PIGMENT_TARGET"};
constexpr int kPigmentKind = static_cast<int>(TargetKind::kPigment);

std::string define(const char* name, int value) {
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

void set_light(const GlProgram& program, const Lighting& light) {
  program.set_vec3("environment", light.environment.L[0].data(), 9);
  program.set("refractive_index", light.refractive_index);
  program.set("normal_reflectance",
              static_cast<float>(fresnel_normal(static_cast<double>(light.refractive_index))));
  program.set("roughness_dry", light.roughness_dry);
  program.set("roughness_wet", light.roughness_wet);
  program.set("varnish", light.varnish);
  program.set("occlusion", light.occlusion);
  std::array<std::array<float, 3>, 3> exposure = white_balance(light.white_xy);
  for (auto& row : exposure) {
    for (float& v : row) v *= std::exp2(light.exposure_ev);
  }
  program.set_mat3("exposure", exposure[0].data());
}

/// Picture coordinates per tangent; the rows of the picture run down, y up.
void set_reflection(const GlProgram& program, const ReflectionMap& map) {
  if (map.rgb[0].empty()) return;
  const float half_fov_rad = map.fov_deg * 3.14159265f / 360;
  const float across = 0.5f / std::tan(half_fov_rad);
  const float down =
      across * static_cast<float>(map.rgb[0].width()) / static_cast<float>(map.rgb[0].height());
  const std::array<float, 2> scale = {map.mirror ? -across : across, -down};
  program.set_vec2("reflection_scale", scale.data());
}

}  // namespace

std::string ShadeVariant::defines() const {
  std::string text = define("PLANES", planes()) + define("SUPERSAMPLE", samples_per_pixel) +
                     define("INTERPOLATE", interpolate) + define("RELIEF_SAMPLES", relief_samples) +
                     define("REFLECTION_MAP", reflection_map) + define("PROBE", probe) +
                     define("GLOSS_LEVELS", GlossTable::kLevels) + define("LAMPS", lamps) +
                     define("SLOPES_READY", slopes_ready()) + define("CELLS_BEFORE", kCellsBefore) +
                     define("OCCLUSION_PLANES", occlusion_planes());
  for (std::size_t i = 1; i < target.size(); ++i) {
    if (target[i] >= 0) text += define(kTargetDefine[i], target[i]);
  }
  return text;
}

void assign_targets(const std::vector<PlaneSource>& planes, ShadeVariant& variant) {
  variant.targets = 1;
  for (int kind = 1; kind <= kPigmentKind; ++kind) {
    for (const PlaneSource& plane : planes) {
      int& target = variant.target[static_cast<std::size_t>(kind)];
      if (static_cast<int>(plane.kind) != kind || target >= 0) continue;
      target = variant.targets;
      variant.targets += kind == kPigmentKind ? variant.planes() : 1;
    }
  }
}

Result<GlProgram> link_shade_program(const GlFunctions& gl, const ShadeVariant& variant) {
  std::string fragment = kGlslVersion + variant.defines();
  for (const char* file : {"surface.glsl", "lamps.glsl", "light.glsl", "shade.frag.glsl"}) {
    fragment += shader_source(file);
  }
  return GlProgram::link(gl, kGlslVersion + std::string(shader_source("triangle.vert.glsl")),
                         fragment);
}

std::array<float, 2> relief_per_cell(const Lighting& lighting, const CanvasGeometry& grid) {
  return {lighting.relief_scale / grid.dx_m(), lighting.relief_scale / grid.dy_m()};
}

void set_shade_uniforms(const GlProgram& program, const ShadeParameters& p) {
  const std::pair<const char*, ShadeUnit> samplers[] = {{"columns", kColumns},
                                                        {"rows", kRows},
                                                        {"ground", kGround},
                                                        {"relief", kRelief},
                                                        {"slopes", kSlopes},
                                                        {"amounts", kAmounts},
                                                        {"reflection_map", kReflectionMap},
                                                        {"seen_first", kSeenFirst},
                                                        {"seen_second", kSeenSecond},
                                                        {"gloss_table", kGloss}};
  for (const auto& [name, unit] : samplers) program.set(name, static_cast<int>(unit));
  program.set_vec2("relief_per_cell", relief_per_cell(p.lighting, p.grid).data());
  program.set("relief_border", p.relief_border);
  set_lamp_uniforms(program, p.grid, p.lighting);
  set_light(program, p.lighting);
  set_reflection(program, p.lighting.reflection);
}

}  // namespace pentimento
