#pragma once
// One plane against another.

#include <string>

#include "core/base/field.h"
#include "replay/compare/comparison.h"

namespace pentimento {

/// Largest and root mean square difference, PSNR against `peak`, share of values that differ.
/// Planes have the same size.
PlaneDifference plane_difference(const std::string& name, FieldView<const float> a,
                                 FieldView<const float> b, double peak);
/// The same for ids.
PlaneDifference plane_difference(const std::string& name, FieldView<const std::uint32_t> a,
                                 FieldView<const std::uint32_t> b, double peak);

/// As above, and how near `b`, reduced from a finer plane, is to `a`:
///   relative L2 = sqrt(sum (a - b)^2 / sum a^2)
///   worst block = max |a - b| / max(|a|, a thousandth of the largest |a|)
/// 0 where both planes are zero, infinite where only `a` is.
PlaneDifference fidelity(const std::string& name, FieldView<const float> a,
                         FieldView<const float> b);

/// Largest |value|, for the peak of a state's dataset.
double largest_value(FieldView<const float> plane);

}  // namespace pentimento
