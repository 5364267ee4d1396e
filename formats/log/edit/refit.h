#pragma once
// Another canvas, another size of brush.

#include "formats/log/edit/event_filter.h"

namespace pentimento::log {

/// x_m = scale * x_m + move_x_m; widths are scaled by scale * size_factor.
struct Refit {
  double scale = 1, move_x_m = 0, move_y_m = 0;
  double size_factor = 1;
};

/// Puts a painting onto a canvas of width_m x height_m, as large as it fits, in the middle. Changes
/// the header: the grid keeps its cells' share of the canvas.
Refit fit_header(Header& header, double width_m, double height_m);

/// Moves touches, scales radii and the slider `size`, whose default is set at the beginning.
class Refitted : public EventFilter {
 public:
  Refitted(const Refit& refit, EventSink next) : EventFilter(std::move(next)), refit_(refit) {}
  void take(const Event& event) override;

 private:
  void begin();
  Refit refit_;
  bool begun_ = false;
};

}  // namespace pentimento::log
