#pragma once
// Changing the resolution of a plane without changing its mean.

#include "core/base/field.h"

namespace pentimento {

/// `in` on another grid over the same area: each new texel is the mean of what it covers (box
/// filter with exact shares). `in` is not empty; new sides >= 1.
Field<float> resample_area(const Field<float>& in, int width, int height);

}  // namespace pentimento
