#include "core/shading/gl_limits.h"

#include <fmt/format.h>

namespace pentimento {
namespace {

Result<void> check(const GlFunctions& gl, GLenum limit, int needed, const std::string& what) {
  GLint most = 0;
  gl.GetIntegerv(limit, &most);
  if (needed <= most) return {};
  return Error{ErrorCode::kLimit,
               fmt::format("{}: that takes {}, this OpenGL has {}", what, needed, most)};
}

}  // namespace

Result<void> check_gl_limits(const GlFunctions& gl, const ShadeVariant& v) {
  if (auto fits = check(gl, GL_MAX_ARRAY_TEXTURE_LAYERS, v.amount_planes(),
                        fmt::format("AOVs of {} channels need many texture layers", v.channels));
      !fits)
    return fits;
  return check(gl, GL_MAX_DRAW_BUFFERS, v.targets,
               fmt::format("AOVs of {} channels need many targets", v.channels));
}

}  // namespace pentimento
