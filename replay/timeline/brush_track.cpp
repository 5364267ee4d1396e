#include "replay/timeline/brush_track.h"

#include "core/model/model.h"
#include "formats/log/tables/slider_fields.h"

namespace pentimento {

BrushTrack::BrushTrack(const BrushTable& brushes) : brushes_(brushes), brush_(&brushes.first()) {}

void BrushTrack::follow(const log::Action& action) {
  if (const auto* slider = std::get_if<log::Slider>(&action)) {
    Model unused;
    log::apply_slider(slider->name, slider->value, settings_, unused);
  } else if (const auto* change = std::get_if<log::BrushChange>(&action)) {
    brush_ = &brushes_.find(change->name);
  }
}

double BrushTrack::spacing_frac() const {
  return static_cast<double>(brush_->spacing > 0 ? brush_->spacing : settings_.spacing);
}

}  // namespace pentimento
