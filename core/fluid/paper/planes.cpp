#include "core/fluid/paper/planes.h"

namespace pentimento::paper {

Planes make_planes(int width, int height, int channels) {
  Planes p;
  for (Field<float>* f :
       {&p.height_m[0],   &p.height_m[1], &p.u_m_s[0],     &p.u_m_s[1],      &p.u_m_s[2],
        &p.v_m_s[0],      &p.v_m_s[1],    &p.v_m_s[2],     &p.mobility_frac, &p.viscosity_m2_s,
        &p.wet,           &p.free_frac,   &p.inflow.u_m_s, &p.inflow.v_m_s,  &p.inflow.count,
        &p.system.centre, &p.system.left, &p.system.right, &p.system.up,     &p.system.down})
    *f = Field<float>(width, height);
  p.moved = Field<std::uint8_t>(width, height);
  p.occupied = Field<std::uint8_t>(width, height);
  for (int c = 0; c < channels; ++c) p.pigment.emplace_back(width, height);
  return p;
}

void prepare_margin_row(const CanvasState& state, int y, Columns margin, Planes& planes) {
  const float* d = state.depth_m.row(y);
  const float* b = state.base_m.row(y);
  float* h = planes.height_m[0].row(y);
  float* wet = planes.wet.row(y);
  for (int x = margin.begin; x < margin.end; ++x) {
    h[x] = d[x] + b[x];
    wet[x] = d[x] > 0.0f ? 1.0f : 0.0f;
  }
  std::copy_n(h + margin.begin, margin.count(), planes.height_m[1].row(y) + margin.begin);
  for (auto* component : {&planes.u_m_s, &planes.v_m_s})
    for (Field<float>& f : *component) std::fill_n(f.row(y) + margin.begin, margin.count(), 0.0f);
  std::fill_n(planes.moved.row(y) + margin.begin, margin.count(), std::uint8_t{0});
}

}  // namespace pentimento::paper
