#pragma once
// The relief of the paper on a grid: a built-in texture or a picture that is repeated. The built-in
// textures are functions of the place on the canvas, so they are the same at every resolution. Each
// value is the mean over its cell, so threads finer than a cell vanish and make no pattern with the
// grid. The relief reaches the state, so it uses core's own arithmetic only.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "formats/log/tables/events.h"
#include "replay/log/log_files.h"

namespace pentimento {

/// The names: linen (fine, uneven threads), canvas (coarse, even), paper (cold-pressed grain),
/// smooth.
std::vector<std::string> builtin_papers();
bool is_builtin_paper(const std::string& name);

/// The relief on a grid that is never held whole.
class PaperRows {
 public:
  virtual ~PaperRows() = default;
  /// Height in metres of the cells [x, x + out.size()) of row y. From any thread.
  virtual void row(int x, int y, std::span<float> out) const = 0;
};
/// Errors: those of the picture file.
Result<std::unique_ptr<PaperRows>> paper_rows(const log::PaperSpec& paper,
                                              const CanvasGeometry& geometry, LogFiles& files);

/// Height in metres of each cell, 0..relief_m. One repeat of the texture is a square of
/// `paper.scale_m` (a picture: its width; its height follows). Errors: those of the picture file.
Result<Field<float>> paper_relief(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                  LogFiles& files);

}  // namespace pentimento
