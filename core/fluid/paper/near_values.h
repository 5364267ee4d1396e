#pragma once
// What planes hold at the departure points of cells beside one another (near_departures.h).

#include <array>

#include "core/base/field.h"
#include "core/fluid/paper/near_departures.h"

namespace pentimento::paper {

/// Of each cell, kGroupCells for each group; unknown where a group has no side.
using NearValues = std::array<float, kMostCells>;

/// interpolate() of a plane at the departure points.
void interpolate_near(const NearDepartures& departures, const Field<float>& plane,
                      NearValues& values);

/// interpolate_product() of two planes.
void interpolate_near_product(const NearDepartures& departures, const Field<float>& f,
                              const Field<float>& g, NearValues& values);

}  // namespace pentimento::paper
