#pragma once
// Whether a program fits what an OpenGL promises to hold.

#include "core/shading/gl/functions.h"
#include "core/shading/shade_program.h"

namespace pentimento {

/// Error kLimit, with what is too much, how much, and how much there may be: channels drawn
/// (texture layers), groups of AOVs (targets). The context is current.
Result<void> check_gl_limits(const GlFunctions& gl, const ShadeVariant& variant);

}  // namespace pentimento
