#include "core/fluid/conservative/solve/force_in_box.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

// Whether any face of a row has a mobility and is not held.
PENTIMENTO_KERNEL
bool any_gives_way(const float* mobility, const float* friction, int n) {
  int any = 0;
  for (int i = 0; i < n; ++i) any |= static_cast<int>((mobility[i] > 0) & (friction[i] > 0));
  return any != 0;
}

PENTIMENTO_KERNEL
bool any_above_zero(const float* value, int n) {
  int any = 0;
  for (int i = 0; i < n; ++i) any |= static_cast<int>(value[i] > 0);
  return any != 0;
}

// Whether any_in_row(nodes, row, x) holds for the nodes of either component in any row of the box,
// from node x on.
template <typename AnyInRow>
bool any_row(const Workspace& work, const CellBox& box, const AnyInRow& any_in_row) {
  for (const NodePlanes* n : {&work.x, &work.y})
    for (int y = box.y0 - 1; y < box.y1; ++y)
      if (any_in_row(*n, y, box.x0 - 1)) return true;
  return false;
}

}  // namespace

bool feels_gravity(const Workspace& work, const CellBox& box) {
  return any_row(work, box, [&](const NodePlanes& n, int y, int x) {
    return any_above_zero(n.mobility_frac.row(y) + x, box.x1 - x);
  });
}

bool gives_way(const Workspace& work, const CellBox& box) {
  return any_row(work, box, [&](const NodePlanes& n, int y, int x) {
    return any_gives_way(n.mobility_frac.row(y) + x, n.friction_frac.row(y) + x, box.x1 - x);
  });
}

}  // namespace pentimento::conservative
