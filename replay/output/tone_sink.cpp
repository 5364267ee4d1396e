#include "replay/output/tone_sink.h"

#include "core/optics/tone.h"

namespace pentimento {

Result<void> ToneSink::write(const PictureStrip& strip) {
  if (curve_ == ToneCurve::kNone) return sink_.write(strip);
  PictureStrip toned{strip.y0, strip.rows, {}, {}};
  rows_.clear();
  for (std::size_t c = 0; c < 3; ++c) {
    const FieldView<const float>& light = strip.plane[c];
    Field<float>& out = rows_.emplace_back(light.width(), strip.rows);
    for (int y = 0; y < strip.rows; ++y) {
      for (int x = 0; x < light.width(); ++x) out(x, y) = tone(curve_, light(x, y));
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    toned.name.push_back(strip.name[c]);
    toned.plane.push_back(rows_[c].view());
  }
  return sink_.write(toned);
}

}  // namespace pentimento
