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

// In which columns around a run there is paint.
struct WetColumns {
  const CellBox& touched;
  const Field<float>& depth_m;
  int reach;
  std::vector<std::uint32_t> wet;  // not 0 where there is; wet[reach] is the run's first column

  // Marks the columns of run `r` in which rows [y0, y1) have paint.
  void mark(const Run& r, int y0, int y1) {
    const int left = std::max(r.x0 - reach, 0);
    const int right = std::min(r.x1 + reach, depth_m.width());
    std::uint32_t* first = wet.data() + (left - r.x0 + reach);
    for (int y = std::max(y0, 0); y < std::min(y1, depth_m.height()); ++y)
      mark_wet_row(depth_m.row(y) + left, right - left, first);
  }
  // Marks those that the brush touches in rows [y0, y1).
  void mark_touched(const Run& r, int y0, int y1) {
    if (touched.y0 >= y1 || touched.y1 <= y0) return;
    const int right = std::min(r.x1 + reach, touched.x1);
    for (int x = std::max(r.x0 - reach, touched.x0); x < right; ++x)
      wet[static_cast<std::size_t>(x - r.x0 + reach)] = 1;
  }
  // Whether the cells [x, end) of run `r` lie within reach of a marked column.
  bool near(const Run& r, int x, int end) const {
    return any_wet(wet.data() + (x - r.x0), end - x + 2 * reach);
  }
  bool all_near(const Run& r) const {
    for (int x = r.x0; x < r.x1; x = end_of_cells(r, x))
      if (!near(r, x, end_of_cells(r, x))) return false;
    return true;
  }

  // Appends the parts of run `r` of rows [y0, y1) that are within reach of paint, or of the brush.
  void find_near(const Run& r, int y0, int y1, std::vector<Run>& out) {
    wet.assign(static_cast<std::size_t>(r.size() + 2 * reach), 0);
    mark(r, y0, y1);
    if (all_near(r)) return out.push_back(r);  // the rows beside it change nothing
    mark(r, y0 - reach, y0);
    mark(r, y1, y1 + reach);
    mark_touched(r, y0 - reach, y1 + reach);
    const std::size_t before = out.size();
    for (int x = r.x0, end = 0; x < r.x1; x = end) {
      end = end_of_cells(r, x);
      if (!near(r, x, end)) continue;
      if (out.size() > before && x - out.back().x1 < WetCells::kLeastGap)
        out.back().x1 = end;
      else
        out.push_back({r.y, x, end});
    }
  }
};

}  // namespace

void WetCells::find(const SleepTiles& tiles, const Field<float>& depth_m, int reach,
                    const Threads& threads) {
  list_bands(tiles);
  constexpr int kBandsPerTask = 8;  // some microseconds
  threads.for_ranges(0, static_cast<int>(bands_.size()), kBandsPerTask, [&](int begin, int end) {
    WetColumns columns{tiles.touched(), depth_m, reach, {}};
    std::vector<Run> near;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      RowBand& band = bands_[k];
      near.clear();
      for (const Run& r : band.runs) columns.find_near(r, band.y0, band.y1, near);
      band.runs.swap(near);
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
