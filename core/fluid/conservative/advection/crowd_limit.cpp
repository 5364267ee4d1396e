#include "core/fluid/conservative/advection/crowd_limit.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

inline float room(const float* depth, int step, float per_most) {
  const float most = std::max(depth[0], std::max(depth[-step], depth[step]));
  return std::min(1.0f, most * per_most);
}

PENTIMENTO_KERNEL
int count_crowded(const CrowdLines& lines, const float* __restrict depth,
                  const float* __restrict edge) {
  const int n = lines.length * lines.step;
  const int step = lines.step;
  const float per_most = 1 / lines.most_m;
  int crowded = 0;
  for (int i = 0; i < n; ++i)
    crowded += 1 + edge[i + step] - edge[i] < room(depth + i, step, per_most) ? 1 : 0;
  return crowded;
}

PENTIMENTO_KERNEL
void push_forward(const CrowdLines& lines, const float* __restrict depth, float* edge) {
  const float per_most = 1 / lines.most_m;
  const int n = (lines.length - 1) * lines.step;
  for (int i = 0; i < n; ++i) {
    const float least = edge[i] - 1 + room(depth + i, lines.step, per_most);
    edge[i + lines.step] = std::max(edge[i + lines.step], least);
  }
}

PENTIMENTO_KERNEL
void push_backward(const CrowdLines& lines, const float* __restrict depth, float* edge) {
  const float per_most = 1 / lines.most_m;
  for (int i = lines.length * lines.step - 1; i >= lines.step; --i) {
    const float most = edge[i + lines.step] + 1 - room(depth + i, lines.step, per_most);
    edge[i] = std::min(edge[i], most);
  }
}

}  // namespace

PENTIMENTO_KERNEL
int count_crowded_row(const CrowdRow& row, float most_m, int n) {
  const float* __restrict lo = row.edge_lo;
  const float* __restrict hi = row.edge_hi;
  const float* __restrict before = row.depth_before;
  const float* __restrict here = row.depth;
  const float* __restrict after = row.depth_after;
  const float per_most = 1 / most_m;
  int crowded = 0;
  for (int i = 0; i < n; ++i) {
    const float beside = before[i] > after[i] ? before[i] : after[i];
    const float most = (here[i] > beside ? here[i] : beside) * per_most;
    crowded += 1 + hi[i] - lo[i] < (most < 1 ? most : 1.0f) ? 1 : 0;
  }
  return crowded;
}

bool limit_crowding(const CrowdLines& lines, const float* depth_m, float* edge) {
  if (count_crowded(lines, depth_m, edge) == 0) return false;
  push_forward(lines, depth_m, edge);
  push_backward(lines, depth_m, edge);
  return true;
}

}  // namespace pentimento::conservative
