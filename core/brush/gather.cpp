#include "core/brush/gather.h"

#include <algorithm>
#include <array>

namespace pentimento {

namespace {
/// Adds w times the paint of the box's cell (x, y), nothing outside it.
void add_cell(const LiftedPaint& lifted, const CellBox& box, int x, int y, float w, float* out) {
  if (x < 0 || y < 0 || x >= box.width || y >= box.height) return;
  const float* paint =
      lifted.paint.data() + (static_cast<std::ptrdiff_t>(y) * box.width + x) * lifted.stride;
  for (int k = 0; k < lifted.stride; ++k) out[k] += w * paint[k];
}

void sample_box(const LiftedPaint& lifted, const CellBox& box, float x, float y, float* out) {
  std::fill_n(out, lifted.stride, 0.0f);
  if (!(x > -1 && y > -1 && x < static_cast<float>(box.width) &&
        y < static_cast<float>(box.height)))
    return;
  const int i = static_cast<int>(x + 1) - 1, j = static_cast<int>(y + 1) - 1;  // floor
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const float wa = (1 - fx) * (1 - fy), wb = fx * (1 - fy), wc = (1 - fx) * fy, wd = fx * fy;
  if (i >= 0 && j >= 0 && i + 1 < box.width && j + 1 < box.height) {
    const float* a =
        lifted.paint.data() + (static_cast<std::ptrdiff_t>(j) * box.width + i) * lifted.stride;
    const float* b = a + lifted.stride;
    const float* c = a + static_cast<std::ptrdiff_t>(box.width) * lifted.stride;
    const float* d = c + lifted.stride;
    for (int k = 0; k < lifted.stride; ++k) out[k] = wa * a[k] + wb * b[k] + wc * c[k] + wd * d[k];
    return;
  }
  add_cell(lifted, box, i, j, wa, out);
  add_cell(lifted, box, i + 1, j, wb, out);
  add_cell(lifted, box, i, j + 1, wc, out);
  add_cell(lifted, box, i + 1, j + 1, wd, out);
}
}  // namespace

void gather_lifted(const LiftedPaint& lifted, const TipPose& pose, const CellBox& box,
                   const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir,
                   GatherScratch& scratch) {
  const auto& texels = tip.texels();
  const std::size_t stride = static_cast<std::size_t>(lifted.stride);
  const std::size_t parts = lifted.sum.size();
  scratch.paint.resize(texels.size() * stride);
  scratch.sum.assign(parts, 0.0);
  const double dx = geometry.width_m / geometry.width, dy = geometry.height_m / geometry.height;
  const float x0 = static_cast<float>(pose.x_m / dx - box.x - 0.5);
  const float y0 = static_cast<float>(pose.y_m / dy - box.y - 0.5);
  const float x_u = pose.x_u / static_cast<float>(dx), x_v = pose.x_v / static_cast<float>(dx);
  const float y_u = pose.y_u / static_cast<float>(dy), y_v = pose.y_v / static_cast<float>(dy);
  float* paint = scratch.paint.data();
  for (const TipTexel& t : texels) {
    sample_box(lifted, box, x0 + x_u * t.u + x_v * t.v, y0 + y_u * t.u + y_v * t.v, paint);
    for (std::size_t k = 0; k < parts; ++k) scratch.sum[k] += static_cast<double>(paint[k]);
    paint += stride;
  }
  const double tip_area =
      static_cast<double>(pose.diameter_m) * static_cast<double>(pose.diameter_m);
  const double cells_per_texel =
      geometry.cell_area_m2() * kReservoirSide * kReservoirSide / tip_area;
  for (std::size_t k = 0; k < parts; ++k) {
    if (!(lifted.sum[k] > 0)) continue;
    const double wanted = lifted.sum[k] * cells_per_texel;
    const double gathered = scratch.sum[k];
    // A tip smaller than a cell may miss it: then all texels share alike.
    const float even =
        gathered > 0 ? 0.0f : static_cast<float>(wanted / static_cast<double>(texels.size()));
    const float scale = gathered > 0 ? static_cast<float>(wanted / gathered) : 0.0f;
    for (std::size_t i = 0; i < texels.size(); ++i)
      reservoir.texel(texels[i].index)[k] += scale * scratch.paint[i * stride + k] + even;
  }
}

}  // namespace pentimento
