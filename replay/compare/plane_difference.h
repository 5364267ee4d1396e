#pragma once
// Compares one plane with another.

#include <string>

#include "core/base/field.h"
#include "replay/compare/comparison.h"

namespace pentimento {

/// The largest and the root mean square difference, PSNR against `peak`, and the share of values
/// that differ. The planes must have the same size.
PlaneDifference plane_difference(const std::string& name, FieldView<const float> a,
                                 FieldView<const float> b, double peak);
/// The same for ids.
PlaneDifference plane_difference(const std::string& name, FieldView<const std::uint32_t> a,
                                 FieldView<const std::uint32_t> b, double peak);

/// The same, and how near `b`, which was reduced from a finer plane, is to `a`:
///   relative L2 = sqrt(sum (a - b)^2 / sum a^2)
///   worst block = max |a - b| / max(|a|, a thousandth of the largest |a|)
/// 0 where both planes are zero, infinite where only `a` is.
PlaneDifference fidelity(const std::string& name, FieldView<const float> a,
                         FieldView<const float> b);

/// Largest |value|, for the peak of a state's dataset.
double largest_value(FieldView<const float> plane);

}  // namespace pentimento
