#include "core/fluid/conservative/advection/remap_stream.h"

namespace pentimento::conservative {
void EdgeStream::resize(int n) {
  n_ = n;
  if (n > ones_.width()) {
    tau_ = Field<float>(n, 2);
    ones_ = Field<float>(n, 1, 1.0f);
  }
  stay_.resize(n);
}

void EdgeStream::plan(int r, const float* edge_lo, const float* edge_hi, bool moves) {
  moves_[static_cast<std::size_t>((r + 3) % 3)] = moves;
  far_.clear();
  if (!moves) return;
  edge_lo_ = edge_lo;
  edge_hi_ = edge_hi;
  float* stay = stay_.row(r);
  plan_remap_row(edge_lo, edge_hi, n_, tau_.row(0), tau_.row(1), stay);
  if (count_far_row(stay, n_) == 0) return;
  for (int i = 0; i < n_; ++i)
    if (stay[i] == 0) far_.push_back(i);
}

void QuantityStream::resize(int n) {
  n_ = n;
  out_lo_.resize(n);
  out_hi_.resize(n);
  if (n > zeros_.width()) zeros_ = Field<float>(n, 1);
}

void QuantityStream::begin() {
  passes_ = {};
  far_.clear();
}

void QuantityStream::flux(const EdgeStream& edges, const RemapOptions& options, int r,
                          const ThreeRows& value, bool some) {
  passes(r) = some && edges.moves(r);
  if (!passes(r)) return;
  flux_rows(options, {edges.tau_.row(0), edges.tau_.row(1)}, value, n_, out_lo_.row(r),
            out_hi_.row(r));
  for (const int i : edges.far_)
    if (value.here[i] != 0)
      far_.push_back({r, i, edges.edge_lo_[i], edges.edge_hi_[i], value.here[i],
                      far_slope(options, value, i)});
}

void QuantityStream::gather(const EdgeStream& edges, int r, float* value) {
  if (any_passes(r)) gather_rows(edges.stay(r), parts(r), n_, value);
}

void QuantityStream::gather_beside(const EdgeStream& edges, int r, const float* moving,
                                   const float* held, float* value) {
  if (any_passes(r)) gather_beside_rows(edges.stay(r), parts(r), moving, held, n_, value);
}

}  // namespace pentimento::conservative
