#include <cstdlib>
#include <string>

#include "core/shading/gl/context.h"

namespace pentimento {

void prepare_mesa(int gl_threads) {
  setenv("LP_NUM_THREADS", std::to_string(gl_threads).c_str(), 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

}  // namespace pentimento
