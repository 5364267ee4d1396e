#include "core/detail/flow/moving_blocks.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/detail/flow/level_detail.h"

namespace pentimento {

namespace {
constexpr int kLooksAround = kLevellingRadius;
constexpr int kLookedAt = 64;  // edges at a time

/// Calls body(x0, x1) for pieces [x0, x1) of a row. The pieces hold all edges of the row that move.
template <typename Body>
void for_moving(const float* edge, int x0, int x1, const Body& body) {
  for (int x = x0; x < x1; x += kLookedAt) {
    int first = x, last = std::min(x + kLookedAt, x1);
    if (!any_not_zero(edge + first, last - first)) continue;
    while (edge[first] == 0) ++first;
    while (edge[last - 1] == 0) --last;
    body(first, last);
  }
}

void add_around(ChangedBlocks& blocks, int y0, int y1, int x0, int x1) {
  for (int y = y0 - kLooksAround; y < y1 + kLooksAround; ++y)
    blocks.add(y, x0 - kLooksAround, x1 + kLooksAround);
}
}  // namespace

void add_moving(const PaintEdges& edges, const std::vector<conservative::Run>& runs,
                ChangedBlocks& blocks) {
  for (const conservative::Run& run : runs) {
    for (const Field<float>& plane : edges.x)
      for_moving(plane.row(run.y), run.x0, run.x1, [&](int first, int last) {
        add_around(blocks, run.y, run.y + 1, first, last + 1);
      });
    for (const Field<float>& plane : edges.y)
      for_moving(plane.row(run.y), run.x0, run.x1,
                 [&](int first, int last) { add_around(blocks, run.y, run.y + 2, first, last); });
  }
}

}  // namespace pentimento
