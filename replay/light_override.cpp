#include "replay/light_override.h"

#include "replay/lighting_track.h"

namespace pentimento {

Result<LightOverride> LightOverride::make(const LightChoice& choice) {
  LightOverride made;
  made.choice_ = choice;
  if (choice.environment.empty()) return made;
  Result<ShCoefficients> coefficients = read_environment(choice.environment);
  if (!coefficients) return coefficients.error();
  made.environment_ = *coefficients;
  return made;
}

void LightOverride::apply(Lighting& lighting) const {
  if (choice_.direction) {
    lighting.lamp.direction = unit_direction(*choice_.direction);
    lighting.lamp.follows_gravity = false;
  }
  if (choice_.follow_gravity) lighting.lamp.follows_gravity = true;
  if (choice_.intensity) lighting.lamp.intensity = static_cast<float>(*choice_.intensity);
  if (choice_.exposure_ev) lighting.exposure_ev = static_cast<float>(*choice_.exposure_ev);
  if (environment_) lighting.environment = *environment_;
}

}  // namespace pentimento
