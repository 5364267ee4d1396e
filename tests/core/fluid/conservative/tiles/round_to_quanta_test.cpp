#include "core/fluid/conservative/tiles/round_to_quanta.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/random.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

/// The definition, cell by cell: what rounding takes is carried to the plane's next wet cell.
void round_plainly(const CellBox& box, float rounder, Field<float>& plane) {
  float carried = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      float& value = plane(x, y);
      if (!(value > 0)) continue;
      const float wanted = value + carried;
      value = std::max(rounded(wanted, rounder), 0.0f);
      carried = wanted - value;
    }
  }
}

/// A number in [0, 1).
float share(std::uint64_t n) {
  return static_cast<float>(splitmix64(7, n) >> 40) * 0x1p-24f;
}

/// 53 x 41 cells, 3 layers of 7 channels. Every third plane has empty rows, and one is empty.
CanvasState blotched() {
  CanvasState state = make_canvas_state({53, 41, 0.053, 0.041}, 3, 7, 3, 1);
  std::uint64_t n = 0;
  const auto blotch = [&](Field<float>& plane, int skip, float most) {
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 53; ++x, ++n)
        if ((y + skip) % 3 != 0 && share(n) > 0.3f) plane(x, y) = most * share(n + 1000000);
  };
  blotch(state.depth_m, 1, 0.004f);
  for (std::size_t k = 0; k + 1 < state.pigment.size(); ++k)
    blotch(state.pigment[k], static_cast<int>(k % 3), 0.02f);
  return state;
}

class RoundToQuanta : public ::testing::TestWithParam<int> {};

TEST_P(RoundToQuanta, IsTheSameForPlanesTogetherAndOneByOne) {
  const Model model;
  const Threads threads(GetParam());
  const std::vector<float> amount(7, 1.0f);
  BrushContact contact = make_brush_contact(53, 41);
  for (const bool everywhere : {true, false}) {
    CanvasState together = blotched(), plainly = blotched();
    CellBox box{0, 53, 0, 41};
    if (!everywhere) {
      together.sleep.assign(1, 1.0f);
      contact.touch(5, 50, 3, 33);
      contact.weight(5, 3) = contact.weight(49, 32) = 1;
      box = {5, 50, 3, 33};
    }
    round_to_quanta(together, {model, {}, 0.02f, contact, amount, threads});
    round_plainly(box, rounder_for(quantum_for(model.max_medium_m)), plainly.depth_m);
    for (Field<float>& plane : plainly.pigment)
      round_plainly(box, rounder_for(quantum_for(model.max_pigment)), plane);
    const auto same = [](const Field<float>& a, const Field<float>& b) {
      for (int y = 0; y < a.height(); ++y)
        if (std::memcmp(a.row(y), b.row(y), sizeof(float) * 53) != 0) return false;
      return true;
    };
    EXPECT_TRUE(same(together.depth_m, plainly.depth_m)) << everywhere;
    for (std::size_t k = 0; k < plainly.pigment.size(); ++k)
      EXPECT_TRUE(same(together.pigment[k], plainly.pigment[k])) << everywhere << " " << k;
  }
}
INSTANTIATE_TEST_SUITE_P(Threads, RoundToQuanta, ::testing::Values(1, 2, 7));

}  // namespace
}  // namespace pentimento::conservative
