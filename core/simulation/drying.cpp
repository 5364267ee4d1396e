#include "core/simulation/drying.h"

#include <algorithm>
#include <array>

#include "core/base/any_not_zero.h"
#include "core/optics/composite.h"

namespace pentimento {

namespace {
double plane_sum(const Field<float>& plane) {
  double sum = 0;
  for (int y = 0; y < plane.height(); ++y) {
    double row = 0;
    for (int x = 0; x < plane.width(); ++x) row += static_cast<double>(plane(x, y));
    sum += row;
  }
  return sum;
}

void add(const PaintFlow& from, PaintFlow& to) {
  to.medium_m3 += from.medium_m3;
  for (std::size_t c = 0; c < from.channel.size(); ++c) to.channel[c] += from.channel[c];
}

/// Depth around row y, the grid's edge repeated beyond it.
CoverageRows depth_around(const Field<float>& depth_m, int y) {
  CoverageRows out;
  for (int n = 0; n < static_cast<int>(out.size()); ++n) {
    const float* row = depth_m.row(std::clamp(y + n - kCoverageReach, 0, depth_m.height() - 1));
    std::vector<float>& to = out[static_cast<std::size_t>(n)];
    to.assign(kCoverageReach, row[0]);
    to.insert(to.end(), row, row + depth_m.width());
    to.insert(to.end(), kCoverageReach, row[depth_m.width() - 1]);
  }
  return out;
}

/// Whether drying may change the reflectance of row y. Most of a canvas is bare at most times.
bool may_be_wet(const CanvasState& state, int y) {
  const auto has_paint = [&](const Field<float>& plane) {
    return any_not_zero(plane.row(y), plane.width());
  };
  return has_paint(state.depth_m) || std::ranges::any_of(state.pigment, has_paint);
}

void dry_row(CanvasState& state, const CompositeOptics& optics, EdgeCells edges, int y) {
  if (!may_be_wet(state, y)) return;
  const auto width = static_cast<std::size_t>(state.geometry.width);
  std::vector<std::vector<float>> dried(state.reflectance.size(), std::vector<float>(width));
  std::vector<float*> reflectance;
  for (std::vector<float>& band : dried) reflectance.push_back(band.data());
  std::vector<float> coverage;
  if (edges == EdgeCells::kPartlyCovered) {
    coverage.resize(width);
    edge_coverage_row(depth_around(state.depth_m, y), coverage);
  }
  composite_row(optics, state, y, coverage, reflectance);
  for (std::size_t band = 0; band < dried.size(); ++band)
    state.reflectance[band].write(0, y, dried[band]);
  std::vector<float> base_m(width);
  for (std::size_t x = 0; x < width; ++x)
    base_m[x] = state.base_m.row(y)[x] + state.depth_m.row(y)[x];
  write_base(state, 0, y, base_m);
}
}  // namespace

PaintFlow wet_paint(const CanvasState& state) {
  const double area = state.geometry.cell_area_m2();
  PaintFlow wet;
  wet.medium_m3 = plane_sum(state.depth_m) * area;
  wet.channel.assign(static_cast<std::size_t>(state.channels), 0.0);
  for (int layer = 0; layer < state.layers; ++layer)
    for (int c = 0; c < state.channels; ++c)
      wet.channel[static_cast<std::size_t>(c)] += plane_sum(state.channel(layer, c)) * area;
  return wet;
}

void dry_canvas(CanvasState& state, const ChannelBasis& basis, const Model& model, EdgeCells edges,
                const Threads& threads, PaintFlow& dried) {
  add(wet_paint(state), dried);
  const CompositeOptics optics = make_composite_optics(basis, model);
  threads.for_rows(state.geometry.height, [&](int y) { dry_row(state, optics, edges, y); });
  for (Field<float>* plane : {&state.depth_m, &state.velocity_x_m_s, &state.velocity_y_m_s})
    plane->fill(0);
  for (Field<float>& plane : state.pigment) plane.fill(0);
  state.stroke.fill(0);
}

}  // namespace pentimento
