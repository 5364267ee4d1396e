#pragma once
// Pigment that neighbours get from neighbours, by vectors (near_departures.h).

#include <cstdint>

#include "core/fluid/paper/near_departures.h"

namespace pentimento::paper {

/// Writes layer_velocity_frac() of `n` cells, given the layers of each that hold pigment.
void layer_shares(int layer, const std::uint8_t* occupied, int n, float* share);

/// What arrives of one plane: P(x - dt u).
void arrive_near(const NearDepartures& departures, const NearRows& plane, int n, float* arrived);

/// What arrives of a plane of the bottom layer, of which `free` is the share that moves: that of
/// the free part, and what is not free.
void arrive_near_free(const NearDepartures& departures, const NearRows& plane, const NearRows& free,
                      int n, float* arrived);

}  // namespace pentimento::paper
