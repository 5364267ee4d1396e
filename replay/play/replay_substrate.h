#pragma once
// The substrate of the detail canvas in a replay: the log's paper at the resolution of the fine
// cells, bare or under a loaded picture.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/field.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_substrate.h"
#include "formats/image/resample.h"
#include "formats/log/tables/events.h"
#include "replay/paper/paper_relief.h"

namespace pentimento {

class ReplaySubstrate : public DetailSubstrate {
 public:
  /// `reflectance`: of the bare paper, per band.
  ReplaySubstrate(std::unique_ptr<PaperRows> paper, std::vector<float> reflectance,
                  const CanvasGeometry& fine);

  void relief_row(int x, int y, std::span<float> out) const override;
  void reflectance_row(int band, int x, int y, std::span<float> out) const override;
  /// From now on the reflectance is that of a picture: linear planes of any size, one per band.
  void load(std::vector<Field<float>> bands);
  /// Back to bare paper.
  void clear() { picture_.clear(); }

 private:
  std::unique_ptr<PaperRows> paper_;
  std::vector<float> reflectance_;  // of the bare paper, per band
  CanvasGeometry fine_;
  std::vector<PictureRows> picture_;  // per band; empty: bare paper
};

}  // namespace pentimento
