#include "core/fluid/conservative/tiles/wet_cells.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

constexpr int kRows = 4;        // of a band; tiles are a whole number of them high
constexpr int kLeastRows = 16;  // between two boxes; fewer belong to one box
constexpr int kCells = 16;      // runs begin at multiples, and end there or with their tile

// Marks the columns in which a row has paint.
PENTIMENTO_KERNEL
void mark_wet_row(const float* __restrict depth, int n, std::uint32_t* __restrict wet) {
  for (int i = 0; i < n; ++i) wet[i] |= std::bit_cast<std::uint32_t>(depth[i]);
}

PENTIMENTO_KERNEL
bool any_wet(const std::uint32_t* wet, int n) {
  std::uint32_t any = 0;
  for (int i = 0; i < n; ++i) any |= wet[i];
  return any != 0;
}

// The end of the cells that belong together with x in run `r`.
int end_of_cells(const Run& r, int x) {
  return std::min((x / kCells + 1) * kCells, r.x1);
}

// Whether all cells of run `r` have paint within `reach` columns, as cut() sees it.
bool all_near(const Run& r, const std::uint32_t* wet, int reach) {
  for (int x = r.x0; x < r.x1; x = end_of_cells(r, x))
    if (!any_wet(wet + (x - r.x0), end_of_cells(r, x) - x + 2 * reach)) return false;
  return true;
}

// Appends the parts of run `r` that have paint within `reach` columns. wet[reach] is the run's
// first column.
void cut(const Run& r, const std::uint32_t* wet, int reach, std::vector<Run>& out) {
  const std::size_t before = out.size();
  for (int x = r.x0, end = 0; x < r.x1; x = end) {
    end = end_of_cells(r, x);
    if (!any_wet(wet + (x - r.x0), end - x + 2 * reach)) continue;
    if (out.size() > before && x - out.back().x1 < WetCells::kLeastGap)
      out.back().x1 = end;
    else
      out.push_back({r.y, x, end});
  }
}

}  // namespace

void WetCells::find(const SleepTiles& tiles, const Field<float>& depth_m, int reach,
                    const Threads& threads) {
  list_bands(tiles);
  constexpr int kBandsPerTask = 8;  // some microseconds
  threads.for_ranges(0, static_cast<int>(bands_.size()), kBandsPerTask, [&](int begin, int end) {
    std::vector<std::uint32_t> wet;
    std::vector<Run> awake;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      RowBand& band = bands_[k];
      awake.swap(band.runs);
      band.runs.clear();
      const int top = std::max(band.y0 - reach, 0);
      const int bottom = std::min(band.y1 + reach, depth_m.height());
      const CellBox& touched = tiles.touched();
      const bool touches = touched.y0 < bottom && touched.y1 > top;
      for (const Run& r : awake) {
        // Which columns have paint in any of these rows, ...
        wet.assign(static_cast<std::size_t>(r.size() + 2 * reach), 0);
        const int first = r.x0 - reach;  // column of wet[0]
        const int left = std::max(first, 0);
        const int right = std::min(r.x1 + reach, depth_m.width());
        const auto mark = [&](int y0, int y1) {
          for (int y = y0; y < y1; ++y)
            mark_wet_row(depth_m.row(y) + left, right - left, wet.data() + (left - first));
        };
        mark(band.y0, band.y1);
        if (all_near(r, wet.data(), reach)) {  // the rows beside it change nothing
          band.runs.push_back(r);
          continue;
        }
        mark(top, band.y0);
        mark(band.y1, bottom);
        for (int x = std::max(left, touched.x0); touches && x < std::min(right, touched.x1); ++x)
          wet[static_cast<std::size_t>(x - first)] = 1;
        // ... and which part of the run is near them.
        cut(r, wet.data(), reach, band.runs);
      }
    }
  });
  list_runs();
  list_boxes(tiles);
}

void WetCells::find_all(const SleepTiles& tiles) {
  list_bands(tiles);
  list_runs();
  list_boxes(tiles);
}

// The rows of awake tiles, as bands that hold the runs of their tiles.
void WetCells::list_bands(const SleepTiles& tiles) {
  tile_width_ = tiles.tile_width();
  const std::vector<Run>& awake = tiles.runs();
  std::size_t bands = 0;
  for (std::size_t i = 0; i < awake.size();) {
    const int y = awake[i].y;
    if (bands == bands_.size()) bands_.emplace_back();
    RowBand& band = bands_[bands++];
    band.y0 = y;
    band.runs.clear();
    for (; i < awake.size() && awake[i].y == y; ++i) band.runs.push_back(awake[i]);
    // The rows below it have as many runs.
    band.y1 = y + 1;
    for (; i < awake.size() && awake[i].y == band.y1 && band.y1 % kRows != 0; ++band.y1)
      i += band.runs.size();
  }
  bands_.resize(bands);
}

void WetCells::list_runs() {
  runs_.clear();
  for (const RowBand& band : bands_)
    for (int y = band.y0; y < band.y1; ++y)
      for (const Run& r : band.runs) runs_.push_back({y, r.x0, r.x1});
}

void WetCells::list_boxes(const SleepTiles& tiles) {
  std::vector<CellBox> wide;
  for (const CellBox& strip : tiles.strips()) {
    const auto same = std::find_if(wide.begin(), wide.end(), [&](const CellBox& b) {
      return b.x1 == strip.x0 && b.y0 == strip.y0 && b.y1 == strip.y1 &&
             strip.x1 - b.x0 <= kMostColumns;
    });
    if (same == wide.end())
      wide.push_back(strip);
    else
      same->x1 = strip.x1;
  }
  boxes_.clear();
  for (const CellBox& columns : wide) cover(columns);
}

// Covers the wet cells in a box of awake tiles by boxes, one below the other.
void WetCells::cover(const CellBox& columns) {
  const std::size_t first = boxes_.size();
  for (const RowBand& band : bands_) {
    if (band.y0 < columns.y0 || band.y0 >= columns.y1) continue;
    int x0 = columns.x1, x1 = columns.x0;
    for (const Run& r : band.runs) {
      if (r.x1 <= columns.x0 || r.x0 >= columns.x1) continue;
      x0 = std::min(x0, std::max(r.x0, columns.x0));
      x1 = std::max(x1, std::min(r.x1, columns.x1));
    }
    if (x0 >= x1) continue;
    if (boxes_.size() > first && band.y0 - boxes_.back().y1 < kLeastRows) {
      CellBox& box = boxes_.back();
      box = {std::min(box.x0, x0), std::max(box.x1, x1), box.y0, band.y1};
    } else {
      boxes_.push_back({x0, x1, band.y0, band.y1});
    }
  }
}

}  // namespace pentimento::conservative
