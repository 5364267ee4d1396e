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
  if (!choice_.lamps.empty()) lighting.lamps = choice_.lamps;
  Lamp& lamp = lighting.lamps.front();
  if (choice_.direction) {
    lamp.direction = unit_direction(*choice_.direction);
    lamp.position_m.reset();
    lamp.follows_gravity = false;
  }
  if (choice_.follow_gravity) lamp.follows_gravity = true;
  if (choice_.intensity) lamp.intensity = static_cast<float>(*choice_.intensity);
  develop(choice_.picture, lighting);
  if (environment_) lighting.environment = *environment_;
}

}  // namespace pentimento
