#include "core/fluid/paper/near_values.h"

#include "core/base/fetch_ahead.h"
#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

/// What is known of a group's cells.
struct GroupCells {
  const std::int32_t* choice;
  const float *fx, *fy;
};

GroupCells cells_of(const NearDepartures& departures, std::size_t first) {
  return {departures.choice.data() + first, departures.fx.data() + first,
          departures.fy.data() + first};
}

/// The rows of a plane that a group gets paint from, at its first cell and column; the fourth of
/// kWideSide alone.
struct NearRows {
  const float *first, *second, *third, *fourth;

  /// The value in a row and column, seen from cell i of the group.
  float value(int i, int row, int column) const {
    const float* from = row == 0 ? first : row == 1 ? second : row == 2 ? third : fourth;
    return from[i + column];
  }
};

NearRows rows_near(const float* plane, const NearGroup& group) {
  return {plane + group.from[0], plane + group.from[1], plane + group.from[2],
          plane + group.from[3]};
}

/// Two values, one below the other.
struct ValuePair {
  float upper, lower;
};

inline ValuePair select(bool first, ValuePair a, ValuePair b) {
  return {first ? a.upper : b.upper, first ? a.lower : b.lower};
}

/// interpolate() of a cell, of whose group value(row, column) is given.
template <int kSide, typename Value>
inline float interpolate_in_window(std::int32_t choice, float fx, float fy, const Value& value) {
  const bool first_row = (choice & kFirstRowBit) != 0, third_row = (choice & kThirdRowBit) != 0;
  const auto in_column = [=](int c) {
    const float a = value(0, c), b = value(1, c), below = value(2, c);
    ValuePair chosen{b, below};
    if constexpr (kSide == kWideSide) chosen = select(third_row, {below, value(3, c)}, chosen);
    return select(first_row, {a, b}, chosen);
  };
  const ValuePair first = in_column(0), second = in_column(1), third = in_column(2);
  ValuePair left = second, right = third;
  if constexpr (kSide == kWideSide) {
    const bool third_column = (choice & kThirdColumnBit) != 0;
    left = select(third_column, third, left);
    right = select(third_column, in_column(3), right);
  }
  const bool first_column = (choice & kFirstColumnBit) != 0;
  left = select(first_column, first, left);
  right = select(first_column, second, right);
  return mix(mix(left.upper, right.upper, fx), mix(left.lower, right.lower, fx), fy);
}

/// Asks for what the row below will read of a plane. A group reads short pieces of many planes,
/// which the processor does not foresee.
inline void fetch_below(const float* plane, const NearGroup& group) {
  fetch_ahead(plane + group.ahead, 1);
}

/// interpolate() in the groups of one side. A kernel for each side: the loop of one that had both
/// would be no vector's.
template <int kSide>
PENTIMENTO_KERNEL void interpolate_groups(const NearDepartures& departures, const float* plane,
                                          float* __restrict all_values) {
  const int groups = departures.groups;
  for (int n = 0; n < groups; ++n) {
    const NearGroup& group = departures.group[static_cast<std::size_t>(n)];
    if (group.side != kSide) continue;
    const auto first = static_cast<std::size_t>(n) * kGroupCells;
    const GroupCells cells = cells_of(departures, first);
    const NearRows f = rows_near(plane, group);
    float* __restrict values = all_values + first;
    fetch_below(plane, group);
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i)
      values[i] = interpolate_in_window<kSide>(
          cells.choice[i], cells.fx[i], cells.fy[i],
          [=](int row, int column) { return f.value(i, row, column); });
  }
}

/// The same for the product of two planes.
template <int kSide>
PENTIMENTO_KERNEL void interpolate_products(const NearDepartures& departures, const float* plane,
                                            const float* factor, float* __restrict all_values) {
  const int groups = departures.groups;
  for (int n = 0; n < groups; ++n) {
    const NearGroup& group = departures.group[static_cast<std::size_t>(n)];
    if (group.side != kSide) continue;
    const auto first = static_cast<std::size_t>(n) * kGroupCells;
    const GroupCells cells = cells_of(departures, first);
    const NearRows f = rows_near(plane, group), g = rows_near(factor, group);
    float* __restrict values = all_values + first;
    fetch_below(plane, group);
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i)
      values[i] = interpolate_in_window<kSide>(
          cells.choice[i], cells.fx[i], cells.fy[i],
          [=](int row, int column) { return f.value(i, row, column) * g.value(i, row, column); });
  }
}

}  // namespace

void interpolate_near(const NearDepartures& departures, const Field<float>& plane,
                      NearValues& values) {
  interpolate_groups<kNearSide>(departures, plane.row(0), values.data());
  interpolate_groups<kWideSide>(departures, plane.row(0), values.data());
}

void interpolate_near_product(const NearDepartures& departures, const Field<float>& f,
                              const Field<float>& g, NearValues& values) {
  interpolate_products<kNearSide>(departures, f.row(0), g.row(0), values.data());
  interpolate_products<kWideSide>(departures, f.row(0), g.row(0), values.data());
}

}  // namespace pentimento::paper
