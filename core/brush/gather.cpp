#include "core/brush/gather.h"

#include <algorithm>
#include <cmath>

namespace pentimento {

namespace {
/// Where texels lie among the cells of a box, and how far each reaches for paint: a tent as wide as
/// texels are apart, and never narrower than a cell, so that no cell under the tip is missed.
struct Reach {
  float x0 = 0, y0 = 0;                      // of the tip's centre, in cells
  float x_u = 0, x_v = 0, y_u = 0, y_v = 0;  // cells per tip unit
  float half_x = 1, half_y = 1;              // of the tent, in cells
};

Reach reach_of(const TipPose& pose, const CellBox& box, const CanvasGeometry& geometry) {
  const double dx = geometry.width_m / geometry.width, dy = geometry.height_m / geometry.height;
  Reach r;
  r.x0 = static_cast<float>(pose.x_m / dx - box.x - 0.5);
  r.y0 = static_cast<float>(pose.y_m / dy - box.y - 0.5);
  r.x_u = pose.x_u / static_cast<float>(dx);
  r.x_v = pose.x_v / static_cast<float>(dx);
  r.y_u = pose.y_u / static_cast<float>(dy);
  r.y_v = pose.y_v / static_cast<float>(dy);
  r.half_x = std::max(1.0f, (std::abs(r.x_u) + std::abs(r.x_v)) / kReservoirSide);
  r.half_y = std::max(1.0f, (std::abs(r.y_u) + std::abs(r.y_v)) / kReservoirSide);
  return r;
}

/// The whole numbers strictly between at - half and at + half, within [0, size).
struct Span {
  int begin = 0, end = 0;
  Span(float at, float half, int size) {
    const float last = static_cast<float>(size);
    begin = static_cast<int>(std::clamp(at - half + 1, 0.0f, last));
    end = static_cast<int>(std::clamp(std::ceil(at + half), 0.0f, last));
  }
};

/// Calls visit(cell, weight) for the cells that a texel reaches, row by row.
template <typename Visit>
void visit_cells(const Reach& r, const TipTexel& t, const CellBox& box, const Visit& visit) {
  const float x = r.x0 + r.x_u * t.u + r.x_v * t.v;
  const float y = r.y0 + r.y_u * t.u + r.y_v * t.v;
  const Span columns(x, r.half_x, box.width);
  const Span rows(y, r.half_y, box.height);
  for (int j = rows.begin; j < rows.end; ++j) {
    const float wy = 1 - std::abs(static_cast<float>(j) - y) / r.half_y;
    for (int i = columns.begin; i < columns.end; ++i) {
      const float w = wy * (1 - std::abs(static_cast<float>(i) - x) / r.half_x);
      if (w > 0)
        visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(box.width) +
                  static_cast<std::size_t>(i),
              w);
    }
  }
}

/// Each cell's paint divided among the weights that reach it, per texel's area; `unreached` takes
/// the paint of cells that none reaches.
void divide_paint(const LiftedPaint& lifted, float cells_per_texel, GatherScratch& scratch,
                  std::vector<float>& unreached) {
  const std::size_t stride = static_cast<std::size_t>(lifted.stride);
  for (std::size_t cell = 0; cell < scratch.weight.size(); ++cell) {
    const float weight = scratch.weight[cell];
    const float factor = weight > 0 ? cells_per_texel / weight : 0.0f;
    for (std::size_t k = 0; k < stride; ++k) {
      const float paint = lifted.paint[cell * stride + k];
      scratch.paint[cell * stride + k] = factor * paint;
      if (!(weight > 0)) unreached[k] += cells_per_texel * paint;
    }
  }
}
}  // namespace

void gather_lifted(const LiftedPaint& lifted, const TipPose& pose, const CellBox& box,
                   const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir,
                   GatherScratch& scratch) {
  const auto& texels = tip.texels();
  const std::size_t stride = static_cast<std::size_t>(lifted.stride);
  const std::size_t cells =
      static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  const Reach reach = reach_of(pose, box, geometry);
  scratch.weight.assign(cells, 0.0f);
  scratch.paint.resize(cells * stride);
  scratch.unreached.assign(stride, 0.0f);
  for (const TipTexel& t : texels) {
    visit_cells(reach, t, box, [&](std::size_t cell, float w) { scratch.weight[cell] += w; });
  }
  const double tip_area =
      static_cast<double>(pose.diameter_m) * static_cast<double>(pose.diameter_m);
  const double cells_per_texel =
      geometry.cell_area_m2() * kReservoirSide * kReservoirSide / tip_area;
  divide_paint(lifted, static_cast<float>(cells_per_texel), scratch, scratch.unreached);
  for (float& paint : scratch.unreached) paint /= static_cast<float>(texels.size());
  for (const TipTexel& t : texels) {
    float* out = reservoir.texel(t.index);
    for (std::size_t k = 0; k < stride; ++k) out[k] += scratch.unreached[k];
    visit_cells(reach, t, box, [&](std::size_t cell, float w) {
      const float* paint = scratch.paint.data() + cell * stride;
      for (std::size_t k = 0; k < stride; ++k) out[k] += w * paint[k];
    });
  }
}

}  // namespace pentimento
