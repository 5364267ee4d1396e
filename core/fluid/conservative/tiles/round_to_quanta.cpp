#include "core/fluid/conservative/tiles/round_to_quanta.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/base/any_not_zero.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

constexpr std::size_t kTogether = 8;

// A plane that is rounded: what turns its values into whole quanta, and what rounding has taken so
// far.
struct RoundedPlane {
  Field<float>* plane = nullptr;
  float rounder = 0;
  float carried = 0;
};

// Rounds `n` cells of kPlanes planes. What is carried goes from cell to cell, so the cells of one
// plane wait for one another; those of several planes do not.
template <std::size_t kPlanes>
void round_rows(std::span<RoundedPlane* const> planes, int x0, int y, int n) {
  std::array<float*, kPlanes> value;
  std::array<float, kPlanes> rounder, carried;
  for (std::size_t k = 0; k < kPlanes; ++k) {
    value[k] = planes[k]->plane->row(y) + x0;
    rounder[k] = planes[k]->rounder;
    carried[k] = planes[k]->carried;
  }
  for (int i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < kPlanes; ++k) {
      const float before = value[k][i];
      const float wanted = before + carried[k];
      const float whole = std::max(rounded(wanted, rounder[k]), 0.0f);
      const bool wet = before > 0;
      carried[k] = wet ? wanted - whole : carried[k];
      value[k][i] = wet ? whole : before;
    }
  }
  for (std::size_t k = 0; k < kPlanes; ++k) planes[k]->carried = carried[k];
}

// round_rows() of as many planes as there are, at most kTogether.
template <std::size_t kPlanes = kTogether>
void round_some(std::span<RoundedPlane* const> planes, int x0, int y, int n) {
  if (planes.size() == kPlanes) return round_rows<kPlanes>(planes, x0, y, n);
  if constexpr (kPlanes > 1) round_some<kPlanes - 1>(planes, x0, y, n);
}

// Rounds the box in all planes. A row that is zero is only read: it may have no memory yet.
void round_planes(const CellBox& box, std::span<RoundedPlane> planes) {
  const int n = box.x1 - box.x0;
  std::array<RoundedPlane*, kTogether> some{};
  for (int y = box.y0; y < box.y1; ++y) {
    std::size_t found = 0;
    for (RoundedPlane& p : planes) {
      if (!any_not_zero(p.plane->row(y) + box.x0, n)) continue;
      some[found++] = &p;
      if (found < kTogether) continue;
      round_some(some, box.x0, y, n);
      found = 0;
    }
    round_some(std::span(some).first(found), box.x0, y, n);
  }
}

}  // namespace

CellBox rounded_box(const BrushContact& contact) {
  CellBox box{contact.weight.width(), 0, contact.row_begin, contact.row_end};
  for (int y = box.y0; y < box.y1; ++y) {
    const float* weight = contact.weight.row(y);
    for (int x = contact.column_begin; x < contact.column_end; ++x) {
      if (!(weight[x] > 0)) continue;
      box.x0 = std::min(box.x0, x);
      box.x1 = std::max(box.x1, x + 1);
    }
  }
  return box;
}

void round_to_quanta(CanvasState& state, const StepInput& in) {
  const CellBox box = state.sleep.empty()
                          ? CellBox{0, state.geometry.width, 0, state.geometry.height}
                          : rounded_box(in.contact);
  if (box.empty()) return;
  std::vector<RoundedPlane> planes{
      {&state.depth_m, rounder_for(quantum_for(in.model.max_medium_m))}};
  for (Field<float>& plane : state.pigment)
    planes.push_back({&plane, rounder_for(quantum_for(in.model.max_pigment))});
  in.threads.for_ranges(0, static_cast<int>(planes.size()), kTogether, [&](int begin, int end) {
    round_planes(box, std::span(planes).subspan(static_cast<std::size_t>(begin),
                                                static_cast<std::size_t>(end - begin)));
  });
}

}  // namespace pentimento::conservative
