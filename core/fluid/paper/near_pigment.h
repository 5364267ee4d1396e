#pragma once
// Pigment that neighbours get from neighbours, by vectors (near_departures.h).

#include "core/fluid/paper/near_departures.h"

namespace pentimento::paper {

/// Writes into row y what arrives of a plane in the groups that are near: P(x - dt u).
void arrive_near(const NearDepartures& departures, const Field<float>& plane, int y,
                 Field<float>& arrived);

/// The same of a plane of the bottom layer, of which `free` is the share that moves: that of the
/// free part, and what is not free.
void arrive_near_free(const NearDepartures& departures, const Field<float>& plane,
                      const Field<float>& free, int y, Field<float>& arrived);

}  // namespace pentimento::paper
