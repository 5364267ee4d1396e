#include "core/base/runs.h"

namespace pentimento::conservative {
namespace {

// Joins the runs of one coarse row where they touch.
void append_joined(std::vector<Run>& row, std::vector<Run>& out) {
  std::sort(row.begin(), row.end(), [](const Run& a, const Run& b) { return a.x0 < b.x0; });
  for (const Run& r : row) {
    if (!out.empty() && out.back().y == r.y && r.x0 <= out.back().x1)
      out.back().x1 = std::max(out.back().x1, r.x1);
    else
      out.push_back(r);
  }
  row.clear();
}

}  // namespace

std::vector<Run> coarsen_runs(const std::vector<Run>& fine) {
  std::vector<Run> out;
  std::vector<Run> row;
  for (const Run& r : fine) {
    if (!row.empty() && row.front().y != r.y / 2) append_joined(row, out);
    row.push_back({r.y / 2, r.x0 / 2, (r.x1 + 1) / 2});
  }
  append_joined(row, out);
  return out;
}

}  // namespace pentimento::conservative
