#include "core/brush/stamp_shares.h"

#include <algorithm>

#include "core/base/approx.h"

namespace pentimento {

namespace {
// Chosen by what strokes look like (docs/brushes.md shows them), where no rule is named.

constexpr float kRefillDiameters = 0.1f;  // R22: distance that the refill share is of
// A rag that only lies on the paint soaks up as if it had gone this part of its way; pressed, all.
constexpr double kRagUnpressed = 0.3, kRagPerPressure = 0.7;
constexpr float kMostMixed = 0.5f;        // A24 is stable so far; two layers are alike then
constexpr float kBladeThickness = 0.14f;  // of the diameter: how long a blade is over a place
}  // namespace

float share_over(float frac, double lengths) {
  const double kept = 1 - static_cast<double>(std::clamp(frac, 0.0f, 1.0f));
  return static_cast<float>(1 - approx::pow(kept, lengths));
}

double travelled_diameters(const Stamp& stamp, const TipPose& pose) {
  return static_cast<double>(stamp.travel_m) / static_cast<double>(pose.diameter_m);
}

float pickup_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose) {
  const double diameters = travelled_diameters(stamp, pose);
  const double pressure = static_cast<double>(pressure_of(stamp));
  return std::max(
      share_over(settings.pickup, diameters),
      share_over(brush.absorb, diameters * (kRagUnpressed + kRagPerPressure * pressure)));
}

float refill_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose) {
  if (!brush.lays_paint()) return 0;
  const double distances =
      static_cast<double>(stamp.travel_m) / static_cast<double>(kRefillDiameters * pose.diameter_m);
  return share_over(settings.refill, distances);
}

float mixing_share(const Stamp& stamp, const BrushSettings& settings, const TipPose& pose) {
  return kMostMixed * pressure_of(stamp) *
         share_over(settings.layer_mixing, travelled_diameters(stamp, pose));
}

float return_share(const Stamp& stamp, const BrushDefinition& brush, const TipPose& pose) {
  return (1 - brush.absorb) * static_cast<float>(-approx::expm1(-travelled_diameters(stamp, pose)));
}

float scraped_share(const Stamp& stamp, const TipPose& pose) {
  return share_over(kScraped,
                    travelled_diameters(stamp, pose) / static_cast<double>(kBladeThickness));
}

}  // namespace pentimento
