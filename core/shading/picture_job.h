#pragma once
// One picture, tile by tile: upload the window of the canvas, draw, read back, hand out strips.

#include <vector>

#include "core/base/threads.h"
#include "core/optics/gloss_table.h"
#include "core/shading/aov.h"
#include "core/shading/gl/objects.h"
#include "core/shading/picture.h"
#include "core/shading/shade_program.h"
#include "core/shading/shader.h"
#include "core/shading/tile_plan.h"

namespace pentimento {

/// What is shown. References only.
struct ShadeScene {
  const CanvasSource& canvas;
  const ChannelBasis& basis;
  const Model& model;
  const Lighting& lighting;
};

/// How the picture is cut into tiles, and how it is computed.
struct PictureLayout {
  SampleAxis x;
  SampleAxis y;
  TilePlan tiles;
  int border = 0;  // cells of relief around a tile's window
  ShadeVariant variant;
  EdgeCells edges = EdgeCells::kPartlyCovered;
};

PictureLayout lay_out(const ShadeScene& scene, const ShadeRequest& request,
                      const std::vector<PlaneSource>& planes);

/// The tools of a picture. All references must outlive the work.
struct ShadeTools {
  const GlFunctions& gl;
  const GlProgram& program;  // of the layout's variant
  const GlossTable* gloss;   // of the light probe; none without one
  const Threads& threads;
};

/// Shades a picture tile by tile. The context must be current. Every strip goes to each sink in
/// turn; the first failure ends the work. Errors: kLimit (no memory for a tile), and those of the
/// sinks.
Result<void> shade_picture(const ShadeTools& tools, const ShadeScene& scene,
                           const PictureLayout& layout, const std::vector<PlaneSource>& planes,
                           const std::vector<PictureSink*>& sinks);

}  // namespace pentimento
