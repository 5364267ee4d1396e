#pragma once
// The GLSL files of core/shading/shaders, compiled into the program.

#include <string_view>

namespace pentimento {

/// Text of the file called `file` ("light.glsl"); empty if there is none.
std::string_view shader_source(std::string_view file);

}  // namespace pentimento
