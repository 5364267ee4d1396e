#include "core/fluid/conservative/solve/stages.h"

#include <algorithm>
#include <atomic>

namespace pentimento::conservative {
namespace {

// A band is worth some ten microseconds: smaller ones have more gaps between them than they save.
constexpr std::int64_t kCellsAndStagesPerTask = 16384;

using StagePass = std::function<void(int stage, const Run& run)>;

/// Rows whose stages are done in one go.
struct Band {
  RowSpan rows;
  bool first = true, last = true;  // of its span: nothing depends on the rows beyond
};

/// Cuts the spans into bands of about `cells` cells, each high enough that the gaps of `stages`
/// stages on either side do not meet.
std::vector<Band> cut_into_bands(const RunIndex& index, int stages, std::int64_t cells) {
  const int least_rows = 2 * stages + 2;
  std::vector<Band> bands;
  for (const RowSpan& span : index.spans()) {
    if (index.cells(span) <= cells) {
      bands.push_back({span});
      continue;
    }
    for (int y = span.y0; y < span.y1;) {
      int end = y + least_rows;
      while (end < span.y1 && index.cells({y, end}) < cells) ++end;
      // What is left must be a band, too.
      if (span.y1 - end < least_rows || 2 * index.cells({end, span.y1}) < cells) end = span.y1;
      bands.push_back({{y, end}, y == span.y0, end == span.y1});
      y = end;
    }
  }
  return bands;
}

/// The rows that stage s of a band is done on at once: all that do not depend on a neighbour band.
RowSpan rows_of_stage(const Band& band, int s) {
  return {band.rows.y0 + (band.first ? 0 : s), band.rows.y1 - (band.last ? 0 : s)};
}

// The stages of a band follow one another down the rows.
void do_band(const Band& band, const RunIndex& index, int stages, const StagePass& pass) {
  for (int y = band.rows.y0; y < band.rows.y1 + stages - 1; ++y)
    for (int s = 0; s < stages; ++s) {
      const RowSpan rows = rows_of_stage(band, s);
      if (y - s >= rows.y0 && y - s < rows.y1)
        index.for_row(y - s, [&](const Run& r) { pass(s, r); });
    }
}

// What two bands left to do around the border between them, once both are done.
void fill_gap(int border, const RunIndex& index, int stages, const StagePass& pass) {
  for (int s = 1; s < stages; ++s)
    for (int y = border - s; y < border + s; ++y)
      index.for_row(y, [&](const Run& r) { pass(s, r); });
}

}  // namespace

RunIndex::RunIndex(std::vector<Run> runs, int height) : runs_(std::move(runs)) {
  const auto rows = static_cast<std::size_t>(height);
  begin_.assign(rows + 1, 0);
  cells_above_.assign(rows + 1, 0);
  for (const Run& r : runs_) {
    ++begin_[static_cast<std::size_t>(r.y) + 1];
    cells_above_[static_cast<std::size_t>(r.y) + 1] += r.size();
    if (spans_.empty() || spans_.back().y1 < r.y) spans_.push_back({r.y, r.y});
    spans_.back().y1 = r.y + 1;
  }
  for (std::size_t y = 1; y <= rows; ++y) {
    begin_[y] += begin_[y - 1];
    cells_above_[y] += cells_above_[y - 1];
  }
}

void for_stages(const Threads& threads, const RunIndex& index, int stages, const StagePass& pass) {
  const std::int64_t all = index.cells();
  const int parts = threads.count() == 1 ? 1 : 4 * threads.count();
  for_stages_in(std::max((all + parts - 1) / parts, kCellsAndStagesPerTask / stages), threads,
                index, stages, pass);
}

void for_stages_in(std::int64_t cells, const Threads& threads, const RunIndex& index, int stages,
                   const StagePass& pass) {
  const std::vector<Band> bands = cut_into_bands(index, stages, cells);
  // How many of the two bands beside the border above a band are done.
  std::vector<std::atomic<int>> done(bands.size() + 1);
  threads.for_ranges(0, static_cast<int>(bands.size()), 1, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      do_band(bands[k], index, stages, pass);
      // Whoever is the second to come to a gap fills it, so that nobody waits.
      if (!bands[k].first && done[k].fetch_add(1, std::memory_order_acq_rel) == 1)
        fill_gap(bands[k].rows.y0, index, stages, pass);
      if (!bands[k].last && done[k + 1].fetch_add(1, std::memory_order_acq_rel) == 1)
        fill_gap(bands[k].rows.y1, index, stages, pass);
    }
  });
}

}  // namespace pentimento::conservative
