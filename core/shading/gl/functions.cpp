#include "core/shading/gl/functions.h"

namespace pentimento {

Result<GlFunctions> load_gl_functions(const GlContext& context) {
  GlFunctions gl;
#define PENTIMENTO_GL_LOAD(name, type)                                      \
  gl.name = reinterpret_cast<type>(context.function("gl" #name));           \
  if (gl.name == nullptr) {                                                 \
    return Error{ErrorCode::kIo, "OpenGL function gl" #name " is missing"}; \
  }
  PENTIMENTO_GL_FUNCTIONS(PENTIMENTO_GL_LOAD)
#undef PENTIMENTO_GL_LOAD
  return gl;
}

}  // namespace pentimento
