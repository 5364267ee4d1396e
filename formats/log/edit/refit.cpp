#include "formats/log/edit/refit.h"

#include <algorithm>
#include <cmath>

#include "core/brush/brush_settings.h"

namespace pentimento::log {

namespace {
constexpr double kLeastSize_m = 1e-5, kMostSize_m = 100;  // of the slider `size`
}

Refit fit_header(Header& header, double width_m, double height_m) {
  Refit out;
  out.scale = std::min(width_m / header.canvas_width_m, height_m / header.canvas_height_m);
  out.move_x_m = (width_m - out.scale * header.canvas_width_m) / 2;
  out.move_y_m = (height_m - out.scale * header.canvas_height_m) / 2;
  const auto cells = [&](int cells_before, double before_m, double after_m) {
    return std::max(1,
                    static_cast<int>(std::lround(cells_before * after_m / (out.scale * before_m))));
  };
  header.grid_width = cells(header.grid_width, header.canvas_width_m, width_m);
  header.grid_height = cells(header.grid_height, header.canvas_height_m, height_m);
  header.canvas_width_m = width_m;
  header.canvas_height_m = height_m;
  return out;
}

void Refitted::begin() {
  if (begun_) return;
  begun_ = true;
  const double factor = refit_.scale * refit_.size_factor;
  if (factor == 1) return;
  Event event;
  event.action = Slider{"size", static_cast<double>(BrushSettings().size_m) * factor};
  hand_on(event);
}

void Refitted::take(const Event& event) {
  begin();
  Event out = event;
  const double factor = refit_.scale * refit_.size_factor;
  if (auto* touch = std::get_if<Touch>(&out.action)) {
    touch->x_m = refit_.scale * touch->x_m + refit_.move_x_m;
    touch->y_m = refit_.scale * touch->y_m + refit_.move_y_m;
    if (touch->radius_m) *touch->radius_m *= factor;
  }
  if (auto* slider = std::get_if<Slider>(&out.action); slider != nullptr && slider->name == "size")
    slider->value = std::clamp(slider->value * factor, kLeastSize_m, kMostSize_m);
  hand_on(out);
}

}  // namespace pentimento::log
