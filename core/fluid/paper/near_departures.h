#pragma once
// What cells beside one another get from cells beside one another, as nearly all do: the departure
// points of a group of cells lie between the same three or four columns and rows, seen from each
// cell. Then vectors read all cells there and choose four (near_values.h). The same bits as cell by
// cell (departure.h).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fluid/paper/departure.h"
#include "core/fluid/paper/grid_rows.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

inline constexpr int kGroupCells = 16;  // a vector of the widest instruction set
/// Groups that are looked at before any plane is read: planes are then read in long pieces, which
/// the processor foresees.
inline constexpr int kMostGroups = 16;
inline constexpr int kMostCells = kGroupCells * kMostGroups;

// What is noted of each cell. Its departure point lies behind the first of its group's columns, or
// the third, else the second; the same of rows. Its paint moves.
inline constexpr std::int32_t kFirstColumnBit = 1, kThirdColumnBit = 2;
inline constexpr std::int32_t kFirstRowBit = 4, kThirdRowBit = 8;
inline constexpr std::int32_t kMovesBit = 16;

// Columns, and rows, that the departure points of a group lie between.
inline constexpr int kNearSide = 3;
inline constexpr int kWideSide = 4;

/// A group: cells [x, x + kGroupCells) of a row.
struct NearGroup {
  int x = 0;
  int side = 0;  // kNearSide, kWideSide; 0 if more, and nothing else of the group is known
  // The first of these columns and of these rows, seen from each cell.
  int shift_x = 0, shift_y = 0;
  // The first cell's first column in each of the rows, and in a row that is not read before the
  // next one but one: in elements from a plane's first.
  std::array<std::ptrdiff_t, kWideSide> from = {};
  std::ptrdiff_t ahead = 0;
};

/// Where the paint of some groups of a row came from.
struct NearDepartures {
  int groups = 0;
  std::array<NearGroup, kMostGroups> group;
  // Of each cell, kGroupCells for each group: the bits above, and the fractions from the column and
  // row.
  std::array<std::int32_t, kMostCells> choice;
  std::array<float, kMostCells> fx, fy;
};

/// What is known of the cells of row y. Pointers point at the row's first cell.
struct NearRow {
  int y = 0;
  GridShape grid;
  const float* u_m_s = nullptr;  // velocity of the surface
  const float* v_m_s = nullptr;
  // Of paint in a layer: the layer, and the layers of each cell that hold pigment (R18). No
  // `occupied`: the surface itself.
  int layer = 0;
  const std::uint8_t* occupied = nullptr;
};

/// Finds the departure points of the groups, whose places are given. A group has no side if the
/// points lie further apart than kWideSide columns and rows, or these beyond the canvas's columns.
void find_near(const StepConstants& k, const NearRow& row, NearDepartures& out);

/// The column, or row, of three that the bits of a cell mean.
inline int chosen_of_three(std::int32_t choice, std::int32_t first_bit, std::int32_t third_bit) {
  return (choice & first_bit) != 0 ? 0 : (choice & third_bit) != 0 ? 2 : 1;
}

/// Goes along the cells of a row: near(departures) for up to kMostGroups groups of cells that have
/// neighbours on both sides, of which those count that have a side, and plainly(begin, end) for all
/// other cells. Where cells are no whole number of groups, the last group has some of the one
/// before again.
template <typename Near, typename Plainly>
void for_near_cells(const StepConstants& k, const NearRow& row, Columns cells, Near near,
                    Plainly plainly) {
  const int first = std::max(cells.begin, 1), last = std::min(cells.end, row.grid.width - 1);
  if (last - first < kGroupCells) {
    if (!cells.empty()) plainly(cells.begin, cells.end);
    return;
  }
  if (cells.begin < first) plainly(cells.begin, first);
  NearDepartures departures;
  for (int begin = first; begin < last; begin += kMostCells) {
    const int count = std::min(kMostCells, last - begin);
    departures.groups = (count + kGroupCells - 1) / kGroupCells;
    for (int g = 0; g < departures.groups; ++g)
      departures.group[static_cast<std::size_t>(g)].x =
          std::min(begin + g * kGroupCells, last - kGroupCells);
    find_near(k, row, departures);
    near(departures);
    for (int g = 0; g < departures.groups; ++g) {
      const NearGroup& group = departures.group[static_cast<std::size_t>(g)];
      if (group.side == 0) plainly(group.x, group.x + kGroupCells);
    }
  }
  if (last < cells.end) plainly(last, cells.end);
}

}  // namespace pentimento::paper
