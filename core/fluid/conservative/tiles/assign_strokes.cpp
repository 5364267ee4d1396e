#include "core/fluid/conservative/tiles/assign_strokes.h"

#include <algorithm>
#include <cstdint>

#include "core/base/kernel.h"

namespace pentimento::conservative {

namespace {
PENTIMENTO_KERNEL
bool any_unassigned(const float* depth, const std::uint32_t* stroke, int n) {
  std::uint32_t any = 0;
  for (int i = 0; i < n; ++i) any |= static_cast<std::uint32_t>(depth[i] > 0 && stroke[i] == 0);
  return any != 0;
}

struct Assignment {
  int x, y;
  std::uint32_t stroke;
};

std::uint32_t latest_around(const Field<std::uint32_t>& stroke, int x, int y) {
  std::uint32_t latest = 0;
  if (x > 0) latest = std::max(latest, stroke(x - 1, y));
  if (x + 1 < stroke.width()) latest = std::max(latest, stroke(x + 1, y));
  if (y > 0) latest = std::max(latest, stroke(x, y - 1));
  if (y + 1 < stroke.height()) latest = std::max(latest, stroke(x, y + 1));
  return latest;
}
// The cells of a run that have paint and no stroke, but a stroke beside them.
void find_unassigned(const CanvasState& state, const Run& r, std::vector<Assignment>& found) {
  for (int x = r.x0; x < r.x1; ++x) {
    if (!(state.depth_m(x, r.y) > 0) || state.stroke(x, r.y) != 0) continue;
    const std::uint32_t stroke = latest_around(state.stroke, x, r.y);
    if (stroke != 0) found.push_back({x, r.y, stroke});
  }
}
}  // namespace

void assign_strokes(CanvasState& state, const std::vector<Run>& runs, const Threads& threads) {
  // All are found before any is written, so that it does not matter who comes first.
  std::vector<std::vector<Assignment>> found(runs.size());
  for_runs(threads, runs, [&](const Run& r) {
    if (any_unassigned(state.depth_m.row(r.y) + r.x0, state.stroke.row(r.y) + r.x0, r.size()))
      find_unassigned(state, r, found[static_cast<std::size_t>(&r - runs.data())]);
  });
  for (const std::vector<Assignment>& of_run : found)
    for (const Assignment& c : of_run) state.stroke(c.x, c.y) = c.stroke;
}

}  // namespace pentimento::conservative
