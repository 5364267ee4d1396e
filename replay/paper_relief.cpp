#include "replay/paper_relief.h"

#include <algorithm>
#include <utility>

#include "formats/image/read_image.h"
#include "formats/image/resample.h"
#include "replay/grain.h"
#include "replay/weave.h"

namespace pentimento {

namespace {
// At the default repeat of 5 cm: linen 1.6 mm a thread, as a primed portrait linen at the scale of
// the 1 m model canvas; canvas 3.1 mm, a coarse duck.
constexpr WeaveShape kLinen{32, 0.35};
constexpr WeaveShape kCanvas{16, 0.1};

Result<Field<float>> picture_height(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                    LogFiles& files) {
  Result<std::string> path = files.use(paper.texture);
  if (!path) return path.error();
  Result<Field<float>> tile = read_grey(*path);
  if (!tile) return tile.error();
  const double height_m = paper.scale_m * tile->height() / tile->width();
  const Field<float>& grey = *tile;
  return sample_tiled(grey.view(), geometry.width, geometry.height,
                      paper.scale_m * geometry.width / geometry.width_m,
                      height_m * geometry.height / geometry.height_m);
}

Result<Field<float>> unit_height(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                 LogFiles& files) {
  const TileGrid grid{geometry.width, geometry.height,
                      paper.scale_m * geometry.width / geometry.width_m,
                      paper.scale_m * geometry.height / geometry.height_m};
  if (paper.texture == "linen") return weave_height(kLinen, grid);
  if (paper.texture == "canvas") return weave_height(kCanvas, grid);
  if (paper.texture == "paper") return grain_height(grid);
  if (paper.texture == "smooth") return Field<float>(geometry.width, geometry.height);
  return picture_height(paper, geometry, files);
}
}  // namespace

std::vector<std::string> builtin_papers() {
  return {"linen", "canvas", "paper", "smooth"};
}

bool is_builtin_paper(const std::string& name) {
  const std::vector<std::string> names = builtin_papers();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Result<Field<float>> paper_relief(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                  LogFiles& files) {
  Result<Field<float>> relief = unit_height(paper, geometry, files);
  if (!relief) return relief.error();
  const float relief_m = static_cast<float>(paper.relief_m);
  for (int y = 0; y < geometry.height; ++y) {
    for (float& height : relief->view().row_span(y)) height *= relief_m;
  }
  return relief;
}

}  // namespace pentimento
