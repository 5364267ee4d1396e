#include "core/canvas/canvas_state.h"

#include <algorithm>

namespace pentimento {

namespace {
template <typename Plane>
std::vector<Plane> clone_planes(const std::vector<Plane>& planes) {
  std::vector<Plane> copy;
  copy.reserve(planes.size());
  for (const Plane& plane : planes) copy.push_back(plane.clone());
  return copy;
}

std::span<const float> base_of(const CanvasState& state, int x, int y, std::size_t cells) {
  return {state.base_m.row(y) + x, cells};
}
}  // namespace

CanvasState make_canvas_state(const CanvasGeometry& geometry, int layers, int channels, int bands,
                              float white) {
  PENTIMENTO_CHECK(geometry.width > 0 && geometry.height > 0);
  PENTIMENTO_CHECK(layers >= 1 && layers <= 8 && channels >= 0 && bands >= 1);
  constexpr int kOthers = 6;  // planes besides those of bands and channels
  PlaneMemory memory(kOthers + bands + layers * channels, geometry.width, geometry.height);
  const auto plane = [&] { return Field<float>(geometry.width, geometry.height, memory); };
  CanvasState s;
  s.geometry = geometry;
  s.layers = layers;
  s.channels = channels;
  s.bands = bands;
  s.depth_m = plane();
  s.velocity_x_m_s = plane();
  s.velocity_y_m_s = plane();
  s.base_m = plane();
  s.paper = DifferencePlane(geometry.width, geometry.height, memory);
  for (int b = 0; b < bands; ++b)
    s.reflectance.emplace_back(geometry.width, geometry.height, white, memory);
  for (int i = 0; i < layers * channels; ++i) s.pigment.push_back(plane());
  s.stroke = Field<std::uint32_t>(geometry.width, geometry.height, memory);
  return s;
}

void read_paper(const CanvasState& state, int x, int y, std::span<float> out) {
  state.paper.read(x, y, base_of(state, x, y, out.size()), out);
}

void write_paper(CanvasState& state, int x, int y, std::span<const float> paper_m) {
  state.paper.write(x, y, base_of(state, x, y, paper_m.size()), paper_m);
}

Field<float> paper_relief_of(const CanvasState& state) {
  Field<float> relief_m(state.base_m.width(), state.base_m.height());
  for (int y = 0; y < relief_m.height(); ++y) read_paper(state, 0, y, relief_m.view().row_span(y));
  return relief_m;
}

void write_base(CanvasState& state, int x, int y, std::span<const float> base_m) {
  std::vector<float> paper_m(base_m.size());
  read_paper(state, x, y, paper_m);
  std::copy(base_m.begin(), base_m.end(), state.base_m.row(y) + x);
  write_paper(state, x, y, paper_m);
}

CanvasState clone_state(const CanvasState& state) {
  CanvasState copy;
  copy.geometry = state.geometry;
  copy.layers = state.layers;
  copy.channels = state.channels;
  copy.bands = state.bands;
  copy.depth_m = state.depth_m.clone();
  copy.velocity_x_m_s = state.velocity_x_m_s.clone();
  copy.velocity_y_m_s = state.velocity_y_m_s.clone();
  copy.base_m = state.base_m.clone();
  copy.paper = state.paper.clone();
  copy.reflectance = clone_planes(state.reflectance);
  copy.pigment = clone_planes(state.pigment);
  copy.stroke = state.stroke.clone();
  copy.step = state.step;
  copy.sleep = state.sleep;
  return copy;
}

}  // namespace pentimento
