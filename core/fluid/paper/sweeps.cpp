#include "core/fluid/paper/sweeps.h"

#include <algorithm>

namespace pentimento::paper {

namespace {
/// Enough for the threads to share a small canvas, many times what the borders take.
constexpr int kLeastBlockRows = 64;
}  // namespace

void for_sweeps(const Threads& threads, int begin, int end, int sweeps,
                const std::function<void(int sweep, int y)>& row) {
  // The rows around two borders may not overlap.
  const int block = std::max(kLeastBlockRows, 2 * sweeps);
  const int blocks = (std::max(end - begin, 0) + block - 1) / block;
  const auto border = [&](int i) { return std::min(begin + i * block, end); };
  // Row by row all sweeps, each a row behind the one before.
  const auto sweep_block = [&](int i) {
    const int first = border(i), last = border(i + 1);
    const int less_above = i > 0 ? 1 : 0, less_below = i + 1 < blocks ? 1 : 0;
    for (int t = first; t < last + sweeps - 1; ++t)
      for (int s = 0; s < sweeps; ++s)
        if (t - s >= first + s * less_above && t - s < last - s * less_below) row(s, t - s);
  };
  threads.for_ranges(0, blocks, 1, [&](int from, int to) {
    for (int i = from; i < to; ++i) sweep_block(i);
  });
  // What the blocks on both sides of a border left out.
  threads.for_ranges(1, blocks, 1, [&](int from, int to) {
    for (int i = from; i < to; ++i)
      for (int s = 1; s < sweeps; ++s)
        for (int y = std::max(border(i) - s, begin); y < std::min(border(i) + s, end); ++y)
          row(s, y);
  });
}

}  // namespace pentimento::paper
