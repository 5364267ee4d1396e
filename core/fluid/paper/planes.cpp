#include "core/fluid/paper/planes.h"

#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

PENTIMENTO_KERNEL
void fill_height_and_wet(const float* __restrict depth_m, const float* __restrict base_m,
                         Columns cells, float* __restrict height_m, float* __restrict wet) {
  for (int x = cells.begin; x < cells.end; ++x) {
    height_m[x] = depth_m[x] + base_m[x];
    wet[x] = depth_m[x] > 0.0f ? 1.0f : 0.0f;
  }
}

}  // namespace

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

void prepare_margin_row(const CanvasState& state, int y, Columns margin, Columns live,
                        Planes& planes) {
  const float* d = state.depth_m.row(y);
  const float* b = state.base_m.row(y);
  float *h = planes.height_m[0].row(y), *other_h = planes.height_m[1].row(y);
  fill_height_and_wet(d, b, margin, h, planes.wet.row(y));
  for (const Columns& outside : around(live, margin)) {
    std::copy_n(h + outside.begin, outside.count(), other_h + outside.begin);
    for (auto* component : {&planes.u_m_s, &planes.v_m_s})
      for (Field<float>& f : *component)
        std::fill_n(f.row(y) + outside.begin, outside.count(), 0.0f);
    std::fill_n(planes.moved.row(y) + outside.begin, outside.count(), std::uint8_t{0});
  }
}

}  // namespace pentimento::paper
