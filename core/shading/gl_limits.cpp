#include "core/shading/gl_limits.h"

#include <fmt/format.h>

namespace pentimento {
namespace {

constexpr int kOtherUniforms = 128;  // floats of light, relief and the rest, with room to spare

/// Floats that K, S, shares and colours of bands take; vectors of three count as four.
int uniform_floats(const ShadeVariant& v) {
  return v.channels * v.band_texels() * 8 + v.channels * 4 + v.band_texels() * 16 + kOtherUniforms;
}

Result<void> check(const GlFunctions& gl, GLenum limit, int needed, const std::string& what) {
  GLint most = 0;
  gl.GetIntegerv(limit, &most);
  if (needed <= most) return {};
  return Error{ErrorCode::kLimit,
               fmt::format("{}: that takes {}, this OpenGL has {}", what, needed, most)};
}

}  // namespace

Result<void> check_gl_limits(const GlFunctions& gl, const ShadeVariant& v) {
  const std::string paint =
      fmt::format("a canvas of {} layers, {} channels and {} bands", v.layers, v.channels, v.bands);
  if (auto fits = check(gl, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, uniform_floats(v),
                        paint + " needs many uniforms");
      !fits)
    return fits;
  if (auto fits = check(gl, GL_MAX_ARRAY_TEXTURE_LAYERS, v.layers * v.planes(),
                        paint + " needs many texture layers");
      !fits)
    return fits;
  return check(gl, GL_MAX_DRAW_BUFFERS, v.targets,
               fmt::format("AOVs of {} channels need many targets", v.channels));
}

}  // namespace pentimento
