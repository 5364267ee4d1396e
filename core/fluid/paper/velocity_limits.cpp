#include "core/fluid/paper/velocity_limits.h"

#include <cmath>
#include <limits>

#include "core/base/kernel.h"

namespace pentimento::paper {

void impose_brush_row(const BrushContact& contact, int y, Columns cells, float* u_m_s,
                      float* v_m_s) {
  if (y < contact.row_begin || y >= contact.row_end) return;
  const float* weight = contact.weight.row(y);
  const float* brush_u = contact.velocity_x_m_s.row(y);
  const float* brush_v = contact.velocity_y_m_s.row(y);
  for (int x = cells.begin; x < cells.end; ++x) {
    if (!(weight[x] > 0.0f)) continue;
    u_m_s[x] = brush_u[x];
    v_m_s[x] = brush_v[x];
  }
}

void close_edge_row(int y, int width, int height, Columns cells, float* u_m_s, float* v_m_s) {
  if (cells.begin == 0) u_m_s[0] = 0.0f;
  if (cells.end == width) u_m_s[width - 1] = 0.0f;
  if (y == 0 || y == height - 1) std::fill(v_m_s + cells.begin, v_m_s + cells.end, 0.0f);
}

PENTIMENTO_KERNEL
void limit_speed_row(const StepConstants& k, Columns cells, float* u_m_s, float* v_m_s) {
  const float threshold = k.threshold_m_s;
  const float cap = k.speed_cap_m_s > 0 ? k.speed_cap_m_s : std::numeric_limits<float>::max();
  for (int x = cells.begin; x < cells.end; ++x) {
    const float u = u_m_s[x], v = v_m_s[x];
    const float speed = std::sqrt(u * u + v * v);
    const float slowed = cap / (speed > cap ? speed : cap);  // exactly 1 up to the cap
    u_m_s[x] = speed < threshold ? 0.0f : u * slowed;
    v_m_s[x] = speed < threshold ? 0.0f : v * slowed;
  }
}

}  // namespace pentimento::paper
