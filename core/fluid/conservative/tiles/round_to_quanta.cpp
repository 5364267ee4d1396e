#include "core/fluid/conservative/tiles/round_to_quanta.h"

#include <algorithm>

#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

void round_plane(const CellBox& box, float quantum, Field<float>& plane) {
  const float rounder = rounder_for(quantum);
  float carried = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    float* value = plane.row(y);
    for (int x = box.x0; x < box.x1; ++x) {
      if (!(value[x] > 0)) continue;
      const float wanted = value[x] + carried;
      const float whole = std::max(rounded(wanted, rounder), 0.0f);
      carried = wanted - whole;
      value[x] = whole;
    }
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
  const int planes = 1 + state.layers * state.channels;
  in.threads.for_ranges(0, planes, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k == 0)
        round_plane(box, quantum_for(in.model.max_medium_m), state.depth_m);
      else
        round_plane(box, quantum_for(in.model.max_pigment),
                    state.pigment[static_cast<std::size_t>(k - 1)]);
    }
  });
}

}  // namespace pentimento::conservative
