#include "core/optics/lamp.h"

#include <cmath>

namespace pentimento {

std::array<float, 3> lamp_direction(const Lamp& lamp, std::array<float, 3> gravity) {
  constexpr double kTellsNothing_m_s2 = 0.1;
  const auto [lx, ly, lz] = lamp.direction;
  const double x = gravity[0], y = gravity[1], z = gravity[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!lamp.follows_gravity || !(length > kTellsNothing_m_s2)) return lamp.direction;
  const double ux = x / length, uy = y / length, uz = z / length;
  if (uz < -1 + 1e-9) return {lx, -ly, -lz};
  // Rodrigues' rotation from z to u about z x u, with (1 - cos)/sin^2 = 1/(1 + u_z).
  const double k = (ux * lx + uy * ly) / (1 + uz);
  return {static_cast<float>(lx - ux * k + ux * lz), static_cast<float>(ly - uy * k + uy * lz),
          static_cast<float>(uz * lz - (ux * lx + uy * ly))};
}

}  // namespace pentimento
