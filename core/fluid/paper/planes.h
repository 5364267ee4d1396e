#pragma once
// The scratch planes of one step. They are valid only in the live cells of that step.

#include <array>
#include <cstdint>
#include <vector>

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/live_rows.h"

namespace pentimento::paper {

/// A five-point system divided by its diagonal: the weights of the four neighbours, and `centre`.
/// For the height, `centre` is the right side; for the viscosity it is the inverse diagonal.
struct Stencil {
  Field<float> centre, left, right, up, down;
};

/// A velocity field to read.
struct Velocity {
  const Field<float>& u_m_s;
  const Field<float>& v_m_s;
};

/// Sums of the velocities of the films that reach a thin cell, and the number of these films
/// (wet_front.h). All 0 between steps.
struct FrontInflow {
  Field<float> u_m_s, v_m_s, count;
};

struct Planes {
  std::array<Field<float>, 2> height_m;      // h = d + b: two, for the sweeps
  std::array<Field<float>, 3> u_m_s, v_m_s;  // [0] right-hand side, [1], [2] for the sweeps
  Field<float> mobility_frac;                // 1 - Phi, 0 where R15 takes gravity away
  Field<float> viscosity_m2_s;               // 0 in stamped cells: their velocity is given
  Field<float> wet;                          // 1 where there is fluid, else 0
  Stencil system;  // of the height (`centre` first holds the traced height), then of the viscosity
  Field<std::uint8_t> moved;     // 1 where velocity was or is not 0
  Field<std::uint8_t> occupied;  // layers that hold pigment
  FrontInflow inflow;
  Field<float> free_frac;             // share of the bottom layer that does not stick
  std::vector<Field<float>> pigment;  // one layer's channels on their way
};

Planes make_planes(int width, int height, int channels);

/// Fills row y of what the kernels read before anything writes it: height and wetness over
/// `margin`; and where `margin` goes beyond `live`, the height of the second buffer, and velocities
/// of 0.
void prepare_margin_row(const CanvasState& state, int y, Columns margin, Columns live,
                        Planes& planes);

}  // namespace pentimento::paper
