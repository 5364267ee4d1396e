#include "core/fluid/conservative/solve/stages.h"

#include <algorithm>

namespace pentimento::conservative {

RunIndex::RunIndex(std::vector<Run> runs, int height) : runs_(std::move(runs)) {
  begin_.assign(static_cast<std::size_t>(height) + 1, 0);
  for (const Run& r : runs_) ++begin_[static_cast<std::size_t>(r.y) + 1];
  for (std::size_t y = 1; y < begin_.size(); ++y) begin_[y] += begin_[y - 1];
}

void for_stages(const Threads& threads, const RunIndex& index, int stages,
                const std::function<void(int, const Run&)>& pass) {
  const int parts = threads.count() == 1 ? 1 : 4 * threads.count();
  for_stages_in((index.height() + parts - 1) / parts, threads, index, stages, pass);
}

void for_stages_in(int wanted, const Threads& threads, const RunIndex& index, int stages,
                   const std::function<void(int, const Run&)>& pass) {
  const int height = index.height();
  const int rows = std::max(2 * stages + 2, wanted);
  const int bands = (height + rows - 1) / rows;
  threads.for_ranges(0, bands, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int y0 = k * rows;
      const int y1 = std::min(y0 + rows, height);
      if (!index.any(y0, y1)) continue;
      for (int y = y0; y < y1 + stages - 1; ++y)
        for (int s = 0; s < stages; ++s) {
          const bool above = y - s < (y0 == 0 ? 0 : y0 + s);
          const bool below = y - s >= (y1 == height ? height : y1 - s);
          if (!above && !below) index.for_rows(y - s, y - s + 1, [&](const Run& r) { pass(s, r); });
        }
    }
  });
  threads.for_ranges(1, bands, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int border = k * rows;
      if (!index.any(border - stages, border + stages)) continue;
      for (int s = 1; s < stages; ++s)
        index.for_rows(border - s, border + s, [&](const Run& r) { pass(s, r); });
    }
  });
}

}  // namespace pentimento::conservative
