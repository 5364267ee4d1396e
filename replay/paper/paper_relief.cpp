#include "replay/paper/paper_relief.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/any_not_zero.h"
#include "formats/image/read_image.h"
#include "formats/image/resample.h"
#include "replay/paper/grain.h"
#include "replay/paper/weave.h"

namespace pentimento {

namespace {
// At the default repeat of 5 cm: linen 1.6 mm a thread, as a primed portrait linen at the scale of
// the 1 m model canvas; canvas 3.1 mm, a coarse duck.
constexpr WeaveShape kLinen{32, 0.35};
constexpr WeaveShape kCanvas{16, 0.1};

/// A texture of heights 0..1 under a relief.
template <typename Texture>
class ScaledRows : public PaperRows {
 public:
  ScaledRows(Texture texture, double relief_m)
      : texture_(std::move(texture)), relief_m_(static_cast<float>(relief_m)) {}
  void row(int x, int y, std::span<float> out) const override {
    texture_.row(x, y, out);
    for (float& height : out) height *= relief_m_;
  }

 private:
  Texture texture_;
  float relief_m_;
};

struct Grain {
  RepeatGrid grid;
  void row(int x, int y, std::span<float> out) const { grain_row(grid, x, y, out); }
};

struct Smooth {
  void row(int, int, std::span<float> out) const { std::fill(out.begin(), out.end(), 0.0f); }
};

template <typename Texture>
std::unique_ptr<PaperRows> scaled(Texture texture, double relief_m) {
  return std::make_unique<ScaledRows<Texture>>(std::move(texture), relief_m);
}

Result<std::unique_ptr<PaperRows>> picture_rows(const log::PaperSpec& paper,
                                                const CanvasGeometry& geometry, LogFiles& files) {
  Result<std::string> path = files.use(paper.texture);
  if (!path) return path.error();
  Result<Field<float>> tile = read_grey(*path);
  if (!tile) return tile.error();
  const double height_m = paper.scale_m * tile->height() / tile->width();
  return scaled(PictureRows::tiled(std::move(*tile), geometry.width, geometry.height,
                                   paper.scale_m * geometry.width / geometry.width_m,
                                   height_m * geometry.height / geometry.height_m),
                paper.relief_m);
}
}  // namespace

std::vector<std::string> builtin_papers() {
  return {"linen", "canvas", "paper", "smooth"};
}

bool is_builtin_paper(const std::string& name) {
  const std::vector<std::string> names = builtin_papers();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Result<std::unique_ptr<PaperRows>> paper_rows(const log::PaperSpec& paper,
                                              const CanvasGeometry& geometry, LogFiles& files) {
  const RepeatGrid grid{geometry.width, geometry.height,
                        paper.scale_m * geometry.width / geometry.width_m,
                        paper.scale_m * geometry.height / geometry.height_m};
  if (paper.texture == "linen") return scaled(Weave(kLinen, grid), paper.relief_m);
  if (paper.texture == "canvas") return scaled(Weave(kCanvas, grid), paper.relief_m);
  if (paper.texture == "paper") return scaled(Grain{grid}, paper.relief_m);
  if (paper.texture == "smooth") return scaled(Smooth{}, paper.relief_m);
  return picture_rows(paper, geometry, files);
}

Result<Field<float>> paper_relief(const log::PaperSpec& paper, const CanvasGeometry& geometry,
                                  LogFiles& files) {
  Result<std::unique_ptr<PaperRows>> rows = paper_rows(paper, geometry, files);
  if (!rows) return rows.error();
  Field<float> relief(geometry.width, geometry.height);
  std::vector<float> row(static_cast<std::size_t>(geometry.width));
  for (int y = 0; y < geometry.height; ++y) {
    (*rows)->row(0, y, row);
    // A smooth paper takes no memory.
    if (any_not_zero(row.data(), geometry.width)) std::copy(row.begin(), row.end(), relief.row(y));
  }
  return relief;
}

}  // namespace pentimento
