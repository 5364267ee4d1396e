#include "replay/play/light_override.h"

#include "replay/play/lighting_track.h"

namespace pentimento {

Result<LightOverride> LightOverride::make(const LightChoice& choice) {
  LightOverride made;
  made.choice_ = choice;
  if (choice.environment.empty()) return made;
  Result<void> read =
      light_by_panorama(choice.environment, choice.soft_environment, made.panorama_);
  if (!read) return read.error();
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
  if (choice_.soft_environment) lighting.probe = {};
  if (choice_.environment.empty()) return;
  lighting.environment = panorama_.environment;
  for (std::size_t c = 0; c < 3; ++c) lighting.probe[c] = panorama_.probe[c].clone();
}

}  // namespace pentimento
