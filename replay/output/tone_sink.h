#pragma once
// Between shading and a picture for a display: the tone curve on red, green and blue.

#include <vector>

#include "core/optics/lighting.h"
#include "core/shading/picture.h"

namespace pentimento {

/// Hands strips on with tone() of their first three planes; those after them are left out, since
/// pictures for a display have no layers. `sink` outlives it.
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
