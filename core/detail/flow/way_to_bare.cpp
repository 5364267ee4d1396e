#include "core/detail/flow/way_to_bare.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr int kWayBeside = 3, kWayAcross = 4;  // thirds of a cell to the cells around

/// 0 for bare cells. Returns whether there are any.
PENTIMENTO_KERNEL
bool mark_bare_row(const float* depth_m, float bare_m, int n, int* __restrict way) {
  int any = 0;
  for (int x = 0; x < n; ++x) {
    const int bare = depth_m[x] > bare_m ? 0 : 1;
    way[x] = bare != 0 ? 0 : way[x];
    any |= bare;
  }
  return any != 0;
}

/// Cells are no further from a bare one than the row beside theirs lets them be.
PENTIMENTO_KERNEL
void lower_by_row(const int* from, int n, int* __restrict way) {
  PENTIMENTO_INDEPENDENT
  for (int x = 0; x < n; ++x) {
    const int straight = from[x] + kWayBeside;
    way[x] = straight < way[x] ? straight : way[x];
  }
  PENTIMENTO_INDEPENDENT
  for (int x = 1; x < n; ++x) {
    const int across = from[x - 1] + kWayAcross;
    way[x] = across < way[x] ? across : way[x];
  }
  PENTIMENTO_INDEPENDENT
  for (int x = 0; x + 1 < n; ++x) {
    const int across = from[x + 1] + kWayAcross;
    way[x] = across < way[x] ? across : way[x];
  }
}
}  // namespace

Field<int> way_to_bare(const Field<float>& depth_m, float bare_m, int far) {
  const int columns = depth_m.width(), rows = depth_m.height();
  Field<int> way(columns, rows, far);
  bool any = false;
  for (int y = 0; y < rows; ++y) any |= mark_bare_row(depth_m.row(y), bare_m, columns, way.row(y));
  if (!any) return way;
  for (int y = 0; y < rows; ++y) {
    if (y > 0) lower_by_row(way.row(y - 1), columns, way.row(y));
    for (int x = 1; x < columns; ++x) way(x, y) = std::min(way(x, y), way(x - 1, y) + kWayBeside);
  }
  for (int y = rows - 1; y >= 0; --y) {
    if (y + 1 < rows) lower_by_row(way.row(y + 1), columns, way.row(y));
    for (int x = columns - 2; x >= 0; --x)
      way(x, y) = std::min(way(x, y), way(x + 1, y) + kWayBeside);
  }
  return way;
}

}  // namespace pentimento
