#include "core/shading/guided_picture.h"

#include <algorithm>

#include "core/shading/light_lock.h"

namespace pentimento {
namespace {

/// Keeps red, green and blue.
class LightSink : public PictureSink {
 public:
  LightSink(int width, int height) {
    for (Field<float>& plane : light) plane = Field<float>(width, height);
  }
  Result<void> write(const PictureStrip& strip) override {
    for (std::size_t c = 0; c < light.size(); ++c)
      for (int y = 0; y < strip.rows; ++y)
        std::copy_n(strip.plane[c].row(y), light[c].width(), light[c].row(strip.y0 + y));
    return {};
  }
  LightPlanes light;
};

}  // namespace

Result<void> shade_guided(Shader& shader, const GuidedCanvas& canvas, const ChannelBasis& basis,
                          const Model& model, const Lighting& lighting, const ShadeRequest& request,
                          const Threads& threads, const std::vector<PictureSink*>& sinks) {
  const CanvasGeometry& guide = canvas.guide.geometry();
  if (!is_inside(request)) return Error{ErrorCode::kUsage, "the crop lies outside the picture"};
  if (request.width <= guide.width && request.height <= guide.height)
    return shader.shade(canvas.guide, basis, model, lighting, request, sinks);
  // The light that the picture must have, cell by cell of the guide.
  ShadeRequest small;
  small.width = std::min(guide.width, request.width);
  small.height = std::min(guide.height, request.height);
  small.tile = request.tile;
  LightSink wanted(small.width, small.height);
  if (auto shaded = shader.shade(canvas.guide, basis, model, lighting, small, {&wanted}); !shaded)
    return shaded;
  // The fine canvas, one slope a cell: the lock sees to its mean. It has its edges itself.
  const LightLockFrame frame = light_lock_frame(request, small.width, small.height);
  ShadeRequest fine = with_border(request, frame);
  fine.relief_samples = 1;
  fine.edges = EdgeCells::kCovered;
  LightLock lock(frame, wanted.light, threads, sinks);
  return shader.shade(canvas.fine, basis, model, lighting, fine, {&lock});
}

}  // namespace pentimento
