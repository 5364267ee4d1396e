#include "core/fluid/paper/near_pigment.h"

#include "core/base/fetch_ahead.h"
#include "core/base/kernel.h"
#include "core/fluid/paper/near_values.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

namespace {

/// Writes into a row what arrives in its groups, given what moves there.
PENTIMENTO_KERNEL
void arrive(const NearDepartures& departures, const float* all_moved, const float* here_row,
            float* __restrict arrived_row, const float* next_row) {
  const int groups = departures.groups;
  for (int g = 0; g < groups; ++g) {
    const NearGroup& group = departures.group[static_cast<std::size_t>(g)];
    if (group.side == 0) continue;
    const auto first = static_cast<std::size_t>(g) * kGroupCells;
    const std::int32_t* choice = departures.choice.data() + first;
    const float *moved = all_moved + first, *here = here_row + group.x;
    float* __restrict arrived = arrived_row + group.x;
    fetch_ahead(next_row + group.x, 1);
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i) {
      const float value = moved[i], own = here[i];
      const bool moves = (choice[i] & kMovesBit) != 0;
      // without_tail() of what moves; one select after the other keeps the loop a vector's.
      const bool is_tail = moves & (value < kNoPigment);
      const float kept = moves ? value : own;
      arrived[i] = is_tail ? 0.0f : kept;
    }
  }
}

/// The same of the bottom layer, of which a share is free to move.
PENTIMENTO_KERNEL
void arrive_beside_residue(const NearDepartures& departures, const float* all_moved,
                           const float* here_row, const float* free_row,
                           float* __restrict arrived_row, const float* next_row) {
  const int groups = departures.groups;
  for (int g = 0; g < groups; ++g) {
    const NearGroup& group = departures.group[static_cast<std::size_t>(g)];
    if (group.side == 0) continue;
    const auto first = static_cast<std::size_t>(g) * kGroupCells;
    const std::int32_t* choice = departures.choice.data() + first;
    const float *moved = all_moved + first, *here = here_row + group.x;
    const float* free = free_row + group.x;
    float* __restrict arrived = arrived_row + group.x;
    fetch_ahead(next_row + group.x, 1);
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i) {
      const float own = here[i];
      const float kept = without_tail(moved[i] + (1.0f - free[i]) * own);
      arrived[i] = (choice[i] & kMovesBit) != 0 ? kept : own;
    }
  }
}

/// The row that is written after row y.
const float* next_row(int y, const Field<float>& plane) {
  return plane.row(std::min(y + 1, plane.height() - 1));
}

}  // namespace

void arrive_near(const NearDepartures& departures, const Field<float>& plane, int y,
                 Field<float>& arrived) {
  NearValues moved;
  interpolate_near(departures, plane, moved);
  arrive(departures, moved.data(), plane.row(y), arrived.row(y), next_row(y, arrived));
}

void arrive_near_free(const NearDepartures& departures, const Field<float>& plane,
                      const Field<float>& free, int y, Field<float>& arrived) {
  NearValues moved;
  interpolate_near_product(departures, plane, free, moved);
  arrive_beside_residue(departures, moved.data(), plane.row(y), free.row(y), arrived.row(y),
                        next_row(y, arrived));
}

}  // namespace pentimento::paper
