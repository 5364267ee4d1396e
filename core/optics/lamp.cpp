#include "core/optics/lamp.h"

#include <cmath>

namespace pentimento {
namespace {

/// `place`, as a tablet whose "up" is `gravity` sees it.
std::array<float, 3> turned(std::array<float, 3> place, std::array<float, 3> gravity) {
  constexpr double kTellsNothing_m_s2 = 0.1;
  const auto [lx, ly, lz] = place;
  const double x = gravity[0], y = gravity[1], z = gravity[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > kTellsNothing_m_s2)) return place;
  const double ux = x / length, uy = y / length, uz = z / length;
  if (uz < -1 + 1e-9) return {lx, -ly, -lz};
  // Rodrigues' rotation from z to u about z x u, with (1 - cos)/sin^2 = 1/(1 + u_z).
  const double k = (ux * lx + uy * ly) / (1 + uz);
  return {static_cast<float>(lx - ux * k + ux * lz), static_cast<float>(ly - uy * k + uy * lz),
          static_cast<float>(uz * lz - (ux * lx + uy * ly))};
}

}  // namespace

std::array<float, 3> lamp_direction(const Lamp& lamp, std::array<float, 3> gravity) {
  return lamp.follows_gravity ? turned(lamp.direction, gravity) : lamp.direction;
}

std::array<float, 3> lamp_position(const Lamp& lamp, std::array<float, 3> gravity) {
  return lamp.follows_gravity ? turned(*lamp.position_m, gravity) : *lamp.position_m;
}

}  // namespace pentimento
