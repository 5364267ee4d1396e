#pragma once
// Separable convolution. Edge pixels continue outwards. For pictures only, never for the state.

#include <vector>

#include "core/base/field.h"
#include "core/base/threads.h"

namespace pentimento {

/// Weights of 2 r + 1 neighbours, the centre at r.
using Taps = std::vector<double>;

/// Convolves along x with `across`, then along y with `down`.
Field<float> convolve(FieldView<const float> in, const Taps& across, const Taps& down,
                      const Threads& threads);

}  // namespace pentimento
