#pragma once
// Pure functions on blocks side by side: by what the lock multiplies them. Source:
// docs/fidelity.md.

#include <array>
#include <cstdint>

#include "core/detail/store/block_rows.h"

namespace pentimento {

/// What each block shall hold on average and what it holds, >= 0.
struct BlockTargets {
  const float* wanted = nullptr;
  const float* held = nullptr;
};

/// Bounds of |wanted / held - 1|. Counts of blocks by these bins; the last lies beyond all bounds.
inline constexpr std::array<float, 7> kRatioBounds = {0.001f, 0.003f, 0.01f, 0.03f,
                                                      0.1f,   0.3f,   1.0f};
using RatioCounts = std::array<std::int64_t, kRatioBounds.size() + 1>;

/// The ratio that a block is smoothed by: wanted / held. It is 1 where either is 0, within 1e-6 of
/// 1, and beyond [1/2, 2], where it would pull the neighbours along. False if all `n` are 1.
bool ratio_row(const BlockTargets& to, int n, float* ratio);

/// The mean weight that a bilinear field gives a block's own centre along one axis, over the
/// `factor` cells of the block. The rest is that of its two neighbours' centres.
float share_of_own_centre(int factor);

/// A field of ratios, given at the blocks' centres, comes nearer to what the blocks need:
///   out = field * wanted / (held * mean), `mean` of the bilinear field over the block
/// It stays as it is where wanted or held is 0, where that factor is within 1e-6 of 1, and where it
/// lies beyond [1/2, 2]. `own`: share_of_own_centre().
void sharpen_row(const BlockTargets& to, const RatioRows& field, float own, int n, float* out);

/// Counts by how much the blocks are off of which neither is 0.
void count_ratios(const BlockTargets& to, int n, RatioCounts& counts);

/// What a block is scaled by, so that it holds what it shall: wanted / held, and 0 where it shall
/// hold nothing. Where it would have to grow more than 16 times, the scale is 1 and `owed` is 1,
/// elsewhere 0. False if all `n` scales are 1.
bool exact_row(const BlockTargets& to, int n, float* scale, std::uint8_t* owed);

}  // namespace pentimento
