#pragma once
// AOVs as pictures of their own, for programs that do not read EXR: `out.png` gets `out.depth.png`
// and so on beside it, with 16 bits per sample. Light is encoded as in the picture. Other
// quantities are numbers on an even scale, which the file names.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_source.h"
#include "core/optics/channels.h"
#include "core/shading/picture.h"
#include "formats/png/png_writer.h"

namespace pentimento {

/// One file: which planes of the strips it holds, and what they mean.
struct AovPicture {
  std::string name;                  // "depth", "pigment.blue"
  std::vector<std::string> planes;   // "depth.Y"; "normal.X", "normal.Y", "normal.Z"
  std::optional<NumberScale> scale;  // none: light
  std::string unit;                  // of the scale: "m", or empty
};

/// The pictures for the groups in `aovs` (core/shading/shader.h). A scale goes from the least to
/// the largest value on the canvas, which is read once. `between_cells`: the picture also shows
/// heights between cells, which may lie beyond the values of the cells. Errors: kUsage, an unknown
/// group.
Result<std::vector<AovPicture>> aov_pictures(const std::vector<std::string>& aovs,
                                             const CanvasSource& canvas, const ChannelBasis& basis,
                                             bool between_cells);

/// `out.png` and "pigment.blue" give `out.pigment.blue.png`. Characters that do not belong into a
/// file name become `_`.
std::string aov_path(const std::string& picture, const std::string& name);

/// Hands on only the planes with these names, in this order. `sink` must outlive it.
class PlaneSink : public PictureSink {
 public:
  PlaneSink(PictureSink& sink, std::vector<std::string> names)
      : sink_(sink), names_(std::move(names)) {}
  Result<void> write(const PictureStrip& strip) override;

 private:
  PictureSink& sink_;
  std::vector<std::string> names_;
};

}  // namespace pentimento
