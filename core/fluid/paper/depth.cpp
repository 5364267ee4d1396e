#include "core/fluid/paper/depth.h"

#include "core/base/kernel.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

PENTIMENTO_KERNEL
void mark_moved_row(const CanvasState& state, int y, Columns cells, const float* u_m_s,
                    const float* v_m_s, std::uint8_t* moved) {
  const float* old_u = state.velocity_x_m_s.row(y);
  const float* old_v = state.velocity_y_m_s.row(y);
  for (int x = cells.begin; x < cells.end; ++x) {
    const bool any =
        (old_u[x] != 0.0f) | (old_v[x] != 0.0f) | (u_m_s[x] != 0.0f) | (v_m_s[x] != 0.0f);
    moved[x] = any ? 1 : 0;
  }
}

bool update_depth_row(const Planes& planes, const Field<float>& height_m, int y, Columns cells,
                      CanvasState& state) {
  const int last_row = height_m.height() - 1;
  const std::uint8_t* above = planes.moved.row(std::max(y - 1, 0));
  const std::uint8_t* here = planes.moved.row(y);
  const std::uint8_t* below = planes.moved.row(std::min(y + 1, last_row));
  const float* h = height_m.row(y);
  const float* b = state.base_m.row(y);
  float* d = state.depth_m.row(y);
  int changed = 0;
  for_cells(cells, height_m.width(), [=, &changed](int x, int l, int r) {
    const int moved = above[x] | here[x] | below[x] | here[l] | here[r];
    const float film = h[x] - b[x];
    const float kept = film < kNoFilm_m ? 0.0f : film;
    const float depth = moved != 0 ? kept : d[x];
    changed |= depth != d[x] ? 1 : 0;
    d[x] = depth;
  });
  return changed != 0;
}

}  // namespace pentimento::paper
