#pragma once
// Resampling: another resolution of a plane, with the same mean.

#include "core/base/field.h"

namespace pentimento {

/// Gives `in` on a grid of `width` x `height` texels over the same area. Each new texel is the mean
/// of what it covers (box filter with exact shares). `in` is not empty; both new sides are >= 1.
Field<float> resample_area(const Field<float>& in, int width, int height);

}  // namespace pentimento
