#include "core/fluid/conservative/advection/momentum_stream.h"

namespace pentimento::conservative {

void MomentumStream::resize(int n) {
  n_ = n;
  for (RowRing* ring : {&mass_lo_, &mass_hi_, &momentum_lo_, &momentum_hi_, &stay_})
    ring->resize(n);
  if (n <= zeros_.width()) return;
  zeros_ = Field<float>(n, 1);
  ones_ = Field<float>(n, 1, 1.0f);
}

void MomentumStream::begin() {
  passes_ = {};
  far_.clear();
  far_speed_.clear();
}

void MomentumStream::leave(const RemapOptions& options, int r, const LoHi& edge, bool moves,
                           const NodeRows& nodes) {
  passes(r) = moves;
  if (!moves) return;
  const LeavingRow out{mass_lo_.row(r), mass_hi_.row(r), momentum_lo_.row(r), momentum_hi_.row(r),
                       stay_.row(r)};
  const int far = leave_momentum_rows(options.superbee, edge, nodes.mass, nodes.velocity, n_, out);
  if (far > 0) take_far(options, r, edge, nodes);
}

void MomentumStream::take_far(const RemapOptions& options, int r, const LoHi& edge,
                              const NodeRows& nodes) {
  const float* stay = stay_.row(r);
  for (int i = 0; i < n_; ++i) {
    if (stay[i] != 0 || nodes.mass.here[i] == 0) continue;
    far_.push_back(
        {r, i, edge.lo[i], edge.hi[i], nodes.mass.here[i], far_slope(options, nodes.mass, i)});
    far_speed_.push_back(nodes.velocity.here[i]);
  }
}

void MomentumStream::settle(int r, const NodesBefore& before, bool divide,
                            const NodesAfter& after) {
  if (!passes(r - 1) && !passes(r) && !passes(r + 1))
    return settle_resting_rows(before, divide, n_, after);
  const auto settle = divide ? settle_velocity_rows : settle_momentum_rows;
  settle(passes(r) ? stay_.row(r) : ones_.row(0), parts(mass_lo_, mass_hi_, r),
         parts(momentum_lo_, momentum_hi_, r), before, n_, after);
}

}  // namespace pentimento::conservative
