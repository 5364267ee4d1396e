#pragma once
// Pigment that cells beside one another get from cells beside one another, as nearly all do: their
// departure points lie between the same three columns and rows, seen from each cell. Then vectors
// read the nine cells there and choose four. The same bits as cell by cell (departure.h).

#include <array>
#include <cstdint>

#include "core/fluid/paper/grid_rows.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

inline constexpr int kTogether = 64;  // cells of a row

/// Where the pigment of some cells of a row came from.
struct NearDepartures {
  // The first of the three columns and of the three rows, seen from each cell.
  int shift_x = 0, shift_y = 0;
  // Of each cell: the column and the row before its departure point, seen from the cell, and the
  // fractions from there; whether anything moves.
  std::array<std::int32_t, kTogether> column, row, moves;
  std::array<float, kTogether> fx, fy;
};

/// What is known of the cells [x, x + n) of row y. All pointers point at cell x.
struct NearCells {
  int x = 0, y = 0, n = 0;       // n at most kTogether
  int last_x = 0, last_y = 0;    // of the canvas
  const float* u_m_s = nullptr;  // velocity of the surface
  const float* v_m_s = nullptr;
  const std::uint8_t* occupied = nullptr;  // layers that hold pigment
};

/// Finds the departure points of a layer's pigment. Returns false if they lie further apart than
/// three columns and rows, or these lie beyond the canvas's columns.
bool find_near(const StepConstants& k, int layer, const NearCells& cells, NearDepartures& out);

/// A plane around some cells of a row. All pointers point at the first cell, but for the shift.
struct NearRows {
  Rows from;          // the three rows that the departure points lie in
  const float* here;  // the cells' own row, without the shift
};

/// What arrives of one plane: P(x - dt u).
void arrive_near(const NearDepartures& departures, const NearRows& plane, int n, float* arrived);

/// What arrives of a plane of the bottom layer, of which `free` is the share that moves: that of
/// the free part, and what is not free.
void arrive_near_free(const NearDepartures& departures, const NearRows& plane, const NearRows& free,
                      int n, float* arrived);

}  // namespace pentimento::paper
