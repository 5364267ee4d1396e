#pragma once
// Strips of a picture on their way from the tiles to the sinks. While the sinks work on one, the
// next is drawn.

#include <span>
#include <vector>

#include "core/base/side_work.h"
#include "core/shading/aov.h"
#include "core/shading/picture.h"
#include "core/shading/shade_program.h"
#include "core/shading/tile_plan.h"

namespace pentimento {

/// Where the planes of a strip are: in which of the targets that are drawn. References only.
struct StripPlanes {
  const std::vector<PlaneSource>& planes;
  const ShadeVariant& variant;
};

class StripWriter {
 public:
  /// Strips of up to `rows` rows of `width` pixels. `beside`: the sinks get them from a thread of
  /// their own, one strip at a time and in order, which takes memory for a second strip. All
  /// references must outlive the writer.
  StripWriter(const StripPlanes& source, int width, int rows, std::vector<PictureSink*> sinks,
              bool beside);

  /// Copies the planes that target `index` holds out of its RGBA texels: `rows` rows of `columns`.
  void take(int index, const PixelRun& columns, int rows, std::span<const float> texels);
  /// Hands the strip to each sink in turn, after all strips before. From then on take() fills the
  /// next. Returns the first failure of a sink; of a strip that is handed on beside, only the next
  /// call returns it, or finish(). After it no sink gets anything.
  Result<void> hand_on(int y0, int rows);
  /// Waits for the last strip.
  Result<void> finish();

 private:
  using StripRows = std::vector<Field<float>>;  // plane by plane

  PictureStrip strip(const StripRows& buffer, int y0, int rows) const;
  Result<void> write(const PictureStrip& strip) const;

  StripPlanes source_;
  std::vector<PictureSink*> sinks_;
  std::vector<StripRows> buffers_;  // one; beside: two, which take turns
  std::size_t filling_ = 0;
  Result<void> written_;
  SideWork work_;  // the last, so that it ends before what it uses
};

}  // namespace pentimento
