#pragma once
// The forward remap (remap_plan.h, remap_rows.h) along y, in place, row after row. What leaves row
// r follows from rows r-1 to r+1 as they were. What row r becomes follows from what leaves rows r-1
// to r+1. So a window of three rows is enough.

#include <array>
#include <vector>

#include "core/base/field.h"
#include "core/fluid/conservative/advection/remap_far.h"
#include "core/fluid/conservative/advection/remap_rows.h"

namespace pentimento::conservative {

/// A window of three rows: row r + 3 takes the place of row r.
class RowRing {
 public:
  /// Makes rows of at least n values. Keeps the memory if it is wide enough.
  void resize(int n) {
    if (n > rows_.width()) rows_ = Field<float>(n, 3);
  }
  float* row(int r) { return rows_.row((r + 3) % 3); }
  const float* row(int r) const { return rows_.row((r + 3) % 3); }

 private:
  Field<float> rows_;
};

/// The plan of the row at hand, and which cells stay in the rows before. All quantities that move
/// with the same velocity share it.
class EdgeStream {
 public:
  void resize(int n);
  /// Plans row r from its two rows of edges. Rows come one after the other, from 0.
  /// `moves`: false if it is known that no edge moves; then the edges are not read.
  void plan(int r, const float* edge_lo, const float* edge_hi, bool moves);
  bool moves(int r) const { return moves_[static_cast<std::size_t>((r + 3) % 3)]; }
  const float* stay(int r) const { return moves(r) ? stay_.row(r) : ones_.row(0); }

 private:
  friend class QuantityStream;
  int n_ = 0;
  Field<float> tau_;  // of the row planned last: over the low edge, over the high edge
  Field<float> ones_;
  RowRing stay_;
  std::array<bool, 3> moves_{};
  std::vector<int> far_;  // cells of the row planned last that move far
  const float* edge_lo_ = nullptr;
  const float* edge_hi_ = nullptr;
};

/// One quantity on its way through the window.
class QuantityStream {
 public:
  void resize(int n);
  /// Forgets the last batch.
  void begin();
  /// Finds what leaves row r, which `edges` planned last. `some`: false if the row is known to be
  /// empty.
  void flux(const EdgeStream& edges, const RemapOptions& options, int r, const ThreeRows& value,
            bool some);
  /// Writes what row r becomes, in place. Call it after flux(), or end(), of row r + 1.
  void gather(const EdgeStream& edges, int r, float* value);
  /// The same for what moves of cells that hold something back (gather_beside_rows()). Where
  /// nothing came or went, `value` is left as it is.
  void gather_beside(const EdgeStream& edges, int r, const float* moving, const float* held,
                     float* value);
  /// Says that row r lies beyond the last row.
  void end(int r) { passes(r) = false; }
  /// The far cells of the rows so far, in the order of rows.
  const std::vector<FarCell>& far() const { return far_; }

 private:
  bool& passes(int r) { return passes_[static_cast<std::size_t>((r + 3) % 3)]; }
  const float* out_lo(int r) { return passes(r) ? out_lo_.row(r) : zeros_.row(0); }
  const float* out_hi(int r) { return passes(r) ? out_hi_.row(r) : zeros_.row(0); }
  bool any_passes(int r) { return passes(r - 1) || passes(r) || passes(r + 1); }
  Parts parts(int r) { return {out_hi(r - 1), out_hi(r), out_lo(r), out_lo(r + 1)}; }
  int n_ = 0;
  RowRing out_lo_, out_hi_;
  Field<float> zeros_;
  std::array<bool, 3> passes_{};  // whether anything leaves the row
  std::vector<FarCell> far_;
};

}  // namespace pentimento::conservative
