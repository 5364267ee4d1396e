#pragma once
// Checks that a shader program fits the limits of the OpenGL at hand.

#include "core/shading/gl/functions.h"
#include "core/shading/shade_program.h"

namespace pentimento {

/// The context must be current. Errors: kLimit, which names what is too much, how much it is, and
/// how much there may be: channels drawn (texture layers) or groups of AOVs (targets).
Result<void> check_gl_limits(const GlFunctions& gl, const ShadeVariant& variant);

}  // namespace pentimento
