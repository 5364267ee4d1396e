#pragma once
// The books of the paint: what the brush laid and lifted, what dried. Together with what is wet on
// the canvas they must balance: deposited - picked up - dried = wet (R25, A20). Sums are doubles in
// a fixed order; a canvas that was restored counts as deposited. Volumes in m^3 for medium; amount
// times m^2 for each channel.

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
