#include "core/detail/flow/level_relief.h"

#include <algorithm>
#include <cmath>

#include "core/detail/flow/relief_bands.h"
#include "core/detail/flow/surface_spline.h"
#include "core/detail/flow/way_to_bare.h"
#include "core/fluid/conservative/solve/capillary_row.h"

namespace pentimento {
namespace {
constexpr float kYieldStress_Pa = 100;  // of oil paint from the tube: brush marks stand in it
constexpr float kBare_m = 1e-6f;        // thinner is no film
// Cells that are nearly bare would get any factor; they change by no more than this.
constexpr float kLeastFactor = 0.125f, kMostFactor = 8;
constexpr int kPasses = 2;  // a ripple leaks into the bands beside its own, where more stands
constexpr int kMargin = 1;  // blocks around that the bands look at

/// Planes of the fine cells in a box of blocks.
struct FineWindow {
  FineWindow(const CellBox& covers, int factor)
      : box(covers),
        base_m(covers.width() * factor, covers.height() * factor),
        depth_m(base_m.width(), base_m.height()) {}
  CellBox box;
  Field<float> base_m, depth_m;
};

CellBox with_margin(const CellBox& box, const CanvasGeometry& guide) {
  return {std::max(0, box.x0 - kMargin), std::min(guide.width, box.x1 + kMargin),
          std::max(0, box.y0 - kMargin), std::min(guide.height, box.y1 + kMargin)};
}

CellBox common(const CellBox& a, const CellBox& b) {
  return {std::max(a.x0, b.x0), std::min(a.x1, b.x1), std::max(a.y0, b.y0), std::min(a.y1, b.y1)};
}

/// Reads the part of a window that lies in one tile.
void read_tile(const DetailCanvas& canvas, int index, FineWindow& window) {
  const DetailLayout& layout = canvas.layout();
  const DetailTile* tile = canvas.find(index);
  const int k = layout.factor();
  const CellBox all = layout.box(index), part = common(all, window.box);
  const int cells = part.width() * k;
  for (int y = part.y0 * k; y < part.y1 * k; ++y) {
    const int row = y - window.box.y0 * k, column = (part.x0 - window.box.x0) * k;
    const std::ptrdiff_t in_tile =
        std::ptrdiff_t{y - all.y0 * k} * layout.side() + (part.x0 - all.x0) * k;
    float* base = window.base_m.row(row) + column;
    if (tile != nullptr && tile->base_m) {
      std::copy_n(tile->base_m.data() + in_tile, cells, base);
    } else {
      canvas.substrate().relief_row(part.x0 * k, y, {base, static_cast<std::size_t>(cells)});
    }
    if (tile != nullptr && tile->depth_m)
      std::copy_n(tile->depth_m.data() + in_tile, cells, window.depth_m.row(row) + column);
  }
}

FineWindow read_window(const DetailCanvas& canvas, const CellBox& box) {
  const DetailLayout& layout = canvas.layout();
  FineWindow window(box, layout.factor());
  const int b = layout.blocks();
  for (int row = box.y0 / b; row <= (box.y1 - 1) / b; ++row)
    for (int column = box.x0 / b; column <= (box.x1 - 1) / b; ++column)
      read_tile(canvas, layout.tile_of(column, row), window);
  return window;
}

/// Share of a film `deep` cells deep that stands `way` thirds of a cell from a bare one. The film
/// rises at conservative::kContactSlope in the mean, or to its full depth on the way `far`: a
/// quarter of an ellipse.
float edge_share(float deep, int way, int far) {
  const float needed = 3 * deep / conservative::kContactSlope;
  const float rise = std::min(needed, static_cast<float>(far));
  if (!(rise > static_cast<float>(way))) return 1;
  const float t = static_cast<float>(way) / rise;
  return std::sqrt(t * (2 - t));
}

/// What one tile's released blocks are multiplied by.
struct TileLevelling {
  DetailTile* tile = nullptr;
  std::vector<BlockStrip> blocks;
  CellBox box;          // around the blocks
  Field<float> factor;  // of the fine cells in `box`
};

/// The released blocks that hold paint, tile by tile.
std::vector<TileLevelling> by_tile(DetailCanvas& canvas, const CanvasState& guide,
                                   const std::vector<ReleasedBlock>& blocks) {
  std::vector<TileLevelling> tiles;
  std::vector<const ReleasedBlock*> order;
  for (const ReleasedBlock& block : blocks) order.push_back(&block);
  std::stable_sort(order.begin(), order.end(), [](const ReleasedBlock* a, const ReleasedBlock* b) {
    return a->at.tile < b->at.tile;
  });
  for (const ReleasedBlock* block : order) {
    const BlockStrip& at = block->at;
    DetailTile* tile = canvas.find(at.tile);
    if (tile == nullptr || !tile->depth_m || !(guide.depth_m(at.x0, at.y) > 0)) continue;
    if (tiles.empty() || tiles.back().tile != tile)
      tiles.push_back({tile, {}, {at.x0, at.x1, at.y, at.y + 1}, {}});
    TileLevelling& here = tiles.back();
    here.blocks.push_back(at);
    here.box = {std::min(here.box.x0, at.x0), std::max(here.box.x1, at.x1),
                std::min(here.box.y0, at.y), std::max(here.box.y1, at.y + 1)};
  }
  return tiles;
}

void find_factors(const DetailCanvas& canvas, const CanvasState& guide, float tension_N_m,
                  TileLevelling& job) {
  const int k = canvas.layout().factor();
  const CellBox box = with_margin(job.box, guide.geometry);
  const FineWindow window = read_window(canvas, box);
  const float cell_m =
      std::sqrt(guide.geometry.dx_m() * guide.geometry.dy_m()) / static_cast<float>(k);
  // The relief over a smooth surface, and what of it stands.
  const Field<float> smooth = surface_spline(guide, box, k);
  Field<float> relief(smooth.width(), smooth.height()), film(smooth.width(), smooth.height());
  for (int y = 0; y < relief.height(); ++y)
    for (int x = 0; x < relief.width(); ++x)
      relief(x, y) = window.base_m(x, y) + window.depth_m(x, y) - smooth(x, y);
  triangle_mean(window.depth_m, k, film);
  for (int pass = 0; pass < kPasses; ++pass)
    level_bands({kYieldStress_Pa / tension_N_m, cell_m}, k, film, relief);
  // Films end at an angle on bare canvas.
  const int far = 3 * k / 2;
  const Field<int> way = way_to_bare(window.depth_m, kBare_m, far);
  const int left = (job.box.x0 - box.x0) * k, top = (job.box.y0 - box.y0) * k;
  job.factor = Field<float>(job.box.width() * k, job.box.height() * k);
  for (int y = 0; y < job.factor.height(); ++y) {
    for (int x = 0; x < job.factor.width(); ++x) {
      const int u = left + x, v = top + y;
      const float depth = window.depth_m(u, v);
      float wanted = smooth(u, v) + relief(u, v) - window.base_m(u, v);
      wanted *= edge_share(wanted / cell_m, way(u, v), far);
      job.factor(x, y) =
          depth > kBare_m ? std::clamp(wanted / depth, kLeastFactor, kMostFactor) : 1.0f;
    }
  }
}

void multiply(const TileLevelling& job, const DetailLayout& layout, TilePlane& plane) {
  const int k = layout.factor();
  for (const BlockStrip& at : job.blocks) {
    for (int y = 0; y < k; ++y) {
      float* values = plane.data() +
                      std::ptrdiff_t{(at.y - job.tile->box.y0) * k + y} * layout.side() +
                      (at.x0 - job.tile->box.x0) * k;
      const float* factor = job.factor.row((at.y - job.box.y0) * k + y) + (at.x0 - job.box.x0) * k;
      for (int x = 0; x < at.blocks() * k; ++x) values[x] *= factor[x];
    }
  }
}
}  // namespace

void level_relief(DetailCanvas& canvas, const CanvasState& guide,
                  const std::vector<ReleasedBlock>& blocks, float tension_N_m,
                  const Threads& threads) {
  if (!(tension_N_m > 0) || canvas.layout().factor() == 1) return;
  std::vector<TileLevelling> jobs = by_tile(canvas, guide, blocks);
  const int count = static_cast<int>(jobs.size());
  const auto for_jobs = [&](const auto& body) {
    threads.for_ranges(0, count, 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) body(jobs[static_cast<std::size_t>(i)]);
    });
  };
  // All tiles look at the paint as it was, then all change.
  for_jobs([&](TileLevelling& job) { find_factors(canvas, guide, tension_N_m, job); });
  for_jobs([&](TileLevelling& job) {
    for (int p = -1; p < static_cast<int>(job.tile->pigment.size()); ++p)
      if (TilePlane& plane = WetPlane{p}.of(*job.tile)) multiply(job, canvas.layout(), plane);
  });
}

}  // namespace pentimento
