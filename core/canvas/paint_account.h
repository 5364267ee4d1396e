#pragma once
// The account of the paint: what the brush deposited and picked up, and what dried. It must balance
// with the wet paint on the canvas: deposited - picked up - dried = wet (R25, A20). Sums are
// doubles in a fixed order. A canvas that was restored counts as deposited. The medium is in m^3,
// each channel in amount times m^2.

#include <vector>

namespace pentimento {

struct PaintFlow {
  double medium_m3 = 0;
  std::vector<double> channel;  // amount x m^2
};

struct PaintAccount {
  PaintFlow deposited;
  PaintFlow picked_up;
  PaintFlow dried;
};

}  // namespace pentimento
