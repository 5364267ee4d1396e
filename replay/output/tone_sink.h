#pragma once
// Applies the tone curve to red, green and blue, between shading and a picture for a display.

#include <vector>

#include "core/optics/lighting.h"
#include "core/shading/picture.h"

namespace pentimento {

/// Hands strips on with tone() of their first three planes. The planes after them are left out, for
/// pictures for a display have no AOVs. `sink` must outlive it.
class ToneSink : public PictureSink {
 public:
  ToneSink(PictureSink& sink, ToneCurve curve) : sink_(sink), curve_(curve) {}
  Result<void> write(const PictureStrip& strip) override;

 private:
  PictureSink& sink_;
  ToneCurve curve_;
  std::vector<Field<float>> rows_;
};

}  // namespace pentimento
