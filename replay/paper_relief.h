#pragma once
// The relief of the paper on a grid: the built-in textures, which are functions of the place on the
// canvas and so the same at every resolution, or a picture laid as tiles. Each value is the mean
// over its cell, so that threads finer than a cell vanish instead of beating with the grid. Reaches
// the state: own arithmetic only.

#include <string>
#include <vector>

#include "core/canvas_state.h"
#include "core/field.h"
#include "core/result.h"
#include "formats/log/events.h"
#include "replay/log_files.h"

namespace pentimento {

/// linen (fine, uneven threads), canvas (coarse, even), paper (cold-pressed grain), smooth.
std::vector<std::string> builtin_papers();
bool is_builtin_paper(const std::string& name);

/// Height in metres of each cell, 0..relief_m. One repeat of the texture is a square of
/// `paper.scale_m` (a picture: its width; its height follows). Errors: those of the picture file.
Result<Field<float>> paper_relief(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                  LogFiles& files);

}  // namespace pentimento
