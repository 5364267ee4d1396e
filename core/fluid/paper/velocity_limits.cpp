#include "core/fluid/paper/velocity_limits.h"

#include <cmath>
#include <limits>

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

void limit_speed_row(const StepConstants& k, Columns cells, float* u_m_s, float* v_m_s) {
  const float threshold = k.threshold_m_s;
  const float cap = k.speed_cap_m_s > 0 ? k.speed_cap_m_s : std::numeric_limits<float>::max();
  for (int x = cells.begin; x < cells.end; ++x) {
    const float speed = std::sqrt(u_m_s[x] * u_m_s[x] + v_m_s[x] * v_m_s[x]);
    const float capped = speed > cap ? cap / speed : 1.0f;
    const float scale = speed < threshold ? 0.0f : capped;
    u_m_s[x] = scale == 0.0f ? 0.0f : u_m_s[x] * scale;
    v_m_s[x] = scale == 0.0f ? 0.0f : v_m_s[x] * scale;
  }
}

}  // namespace pentimento::paper
