#pragma once
// A canvas becomes a picture: Kubelka-Munk, irradiance, Torrance-Sparrow, reflection
// (R29-R35) in GLSL, in tiles with borders, through an offscreen context. Any size; the picture's
// pixels and the canvas's cells are independent: where pixels are smaller, bilinear cells and
// normals from bicubic height (A38); where they are larger, the mean of the cells' light, each the
// mean over four slopes of the bicubic height within the cell (A39).

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_source.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/edge_coverage.h"
#include "core/optics/lighting.h"
#include "core/shading/picture.h"
#include "core/shading/tile_plan.h"

namespace pentimento {

enum class GlBackend { kAuto, kOsmesa, kEgl };

struct ShadeRequest {
  int width = 0;  // of the whole picture, pixels
  int height = 0;
  int crop_x = 0;  // the part that is shaded; crop_width 0 = all of it
  int crop_y = 0;
  int crop_width = 0;
  int crop_height = 0;
  int tile = kPictureTile;  // side of a tile without its border; smaller where memory asks
  /// Slopes per cell and axis whose light a cell's is the mean of, where pixels are no smaller than
  /// cells: 2, or 1, which is faster and glitters more.
  int relief_samples = 2;
  /// What cells at the edges of wet paint are (A40). kCovered is for a canvas finer than the guide.
  EdgeCells edges = EdgeCells::kPartlyCovered;
  std::vector<std::string> aovs;  // groups: albedo normal height depth diffuse specular reflection
                                  // wet pigment
};

/// Whether the picture has pixels and the crop lies in it.
bool is_inside(const ShadeRequest& request);

class Shader {
 public:
  /// Opens the context. kAuto: OSMesa, then EGL. `gl_threads`: Mesa's own (0 = in the caller),
  /// which it reads once per process, and those of what is computed beside it. Sets environment
  /// variables: call it before other threads start.
  static Result<std::unique_ptr<Shader>> open(GlBackend backend, int gl_threads);
  virtual ~Shader() = default;
  /// Shades `canvas` into `sinks`, strip by strip; strips count rows from the top of the crop. The
  /// first failing sink ends it. The lamp stands where `lighting` says: a lamp that follows gravity
  /// is turned by the caller (optics/lamp.h). From any thread, one at a time.
  /// Errors: kUsage (crop outside, unknown AOV, a canvas of other bands than the basis), kLimit
  /// (more channels and bands than OpenGL holds, no memory for a tile), a sink's own.
  virtual Result<void> shade(const CanvasSource& canvas, const ChannelBasis& basis,
                             const Model& model, const Lighting& lighting,
                             const ShadeRequest& request,
                             const std::vector<PictureSink*>& sinks) = 0;
  /// For provenance: backend, renderer and version.
  virtual std::string description() const = 0;
};

/// The channel names that `aovs` groups stand for, in order, after R, G, B. Error: unknown group.
Result<std::vector<std::string>> aov_channels(const std::vector<std::string>& aovs,
                                              const ChannelBasis& basis);

}  // namespace pentimento
