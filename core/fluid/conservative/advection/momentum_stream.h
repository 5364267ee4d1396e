#pragma once
// Moves the fluid around velocity nodes along y, with its momentum, in place, row after row: as
// remap_stream.h moves a quantity, and with the kernels of momentum_rows.h.

#include <array>
#include <vector>

#include "core/fluid/conservative/advection/momentum_rows.h"
#include "core/fluid/conservative/advection/remap_far.h"
#include "core/fluid/conservative/advection/remap_stream.h"

namespace pentimento::conservative {

/// A row of nodes and the rows above and below it, as they were before anything moved.
struct NodeRows {
  ThreeRows mass;
  ThreeRows velocity;
};

class MomentumStream {
 public:
  void resize(int n);
  /// Forgets the last batch.
  void begin();
  /// Finds what leaves row r over its two rows of edges. `moves`: false if it is known that no edge
  /// moves; then the edges are not read.
  void leave(const RemapOptions& options, int r, const LoHi& edge, bool moves,
             const NodeRows& nodes);
  /// Says that row r lies beyond the last row.
  void end(int r) { passes(r) = false; }
  /// Writes what row r becomes: mass, and velocity if `divide`, else momentum. Call it after
  /// leave(), or end(), of row r + 1.
  void settle(int r, const NodesBefore& before, bool divide, const NodesAfter& after);
  /// The far nodes of the rows so far, in the order of rows, and their velocities.
  const std::vector<FarCell>& far() const { return far_; }
  const std::vector<float>& far_speed() const { return far_speed_; }

 private:
  bool& passes(int r) { return passes_[static_cast<std::size_t>((r + 3) % 3)]; }
  const float* row_of(RowRing& ring, int r) { return passes(r) ? ring.row(r) : zeros_.row(0); }
  Parts parts(RowRing& lo, RowRing& hi, int r) {
    return {row_of(hi, r - 1), row_of(hi, r), row_of(lo, r), row_of(lo, r + 1)};
  }
  void take_far(const RemapOptions& options, int r, const LoHi& edge, const NodeRows& nodes);

  int n_ = 0;
  RowRing mass_lo_, mass_hi_, momentum_lo_, momentum_hi_, stay_;
  Field<float> zeros_, ones_;
  std::array<bool, 3> passes_{};  // whether anything leaves the row
  std::vector<FarCell> far_;
  std::vector<float> far_speed_;
};

}  // namespace pentimento::conservative
