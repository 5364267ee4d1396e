#include "core/fluid/conservative/advection/remap_stream.h"

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/advection/remap_momentum.h"

namespace pentimento::conservative {
namespace {

PENTIMENTO_KERNEL
void times_rows(const float* __restrict mass, int n, float* __restrict velocity) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) velocity[i] *= mass[i];
}

float slope_at(const RemapOptions& options, const ThreeRows& value, int i) {
  const float below = value.here[i] - value.before[i];
  const float above = value.after[i] - value.here[i];
  return options.superbee ? limited_superbee(below, above) : limited_mc(below, above);
}

}  // namespace

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
      far_.push_back(
          {r, i, edges.edge_lo_[i], edges.edge_hi_[i], value.here[i], slope_at(options, value, i)});
}

bool QuantityStream::gather(const EdgeStream& edges, int r, float* value) {
  if (!passes(r - 1) && !passes(r) && !passes(r + 1)) return false;
  gather_rows(edges.stay(r), {out_hi(r - 1), out_hi(r), out_lo(r), out_lo(r + 1)}, n_, value);
  return true;
}

void MomentumStream::resize(int n) {
  mass_.resize(n);
  out_lo_.resize(n);
  out_hi_.resize(n);
}

void MomentumStream::begin() {
  mass_.begin();
  far_speed_.clear();
}

void MomentumStream::flux(const EdgeStream& edges, const RemapOptions& options, int r,
                          const ThreeRows& mass, const ThreeRows& velocity) {
  const std::size_t known = mass_.far().size();
  mass_.flux(edges, options, r, mass, true);
  if (!edges.moves(r)) return;
  momentum_flux_rows({edges.tau_.row(0), edges.tau_.row(1)}, velocity,
                     {mass_.out_lo(r), mass_.out_hi(r)}, mass_.n_, out_lo_.row(r), out_hi_.row(r));
  for (std::size_t k = known; k < mass_.far().size(); ++k)
    far_speed_.push_back(velocity.here[mass_.far()[k].lane]);
}

void MomentumStream::gather(const EdgeStream& edges, int r, float* mass, float* velocity,
                            bool divide) {
  const auto lo = [&](int row) {
    return mass_.passes(row) ? out_lo_.row(row) : mass_.zeros_.row(0);
  };
  const auto hi = [&](int row) {
    return mass_.passes(row) ? out_hi_.row(row) : mass_.zeros_.row(0);
  };
  times_rows(mass, mass_.n_, velocity);
  if (mass_.gather(edges, r, mass))
    gather_rows(edges.stay(r), {hi(r - 1), hi(r), lo(r), lo(r + 1)}, mass_.n_, velocity);
  if (divide) velocity_row(mass, velocity, mass_.n_);
}

}  // namespace pentimento::conservative
