#include "core/brush/blade_ends.h"

#include <algorithm>

#include "core/base/approx.h"
#include "core/brush/stamp_shares.h"

namespace pentimento {

BladeEnds blade_ends(const Tip& tip, const TipPose& pose, const CanvasGeometry& grid) {
  const float width = cell_width(pose, grid);
  const double most_scraped = approx::log(1 - static_cast<double>(kScraped));
  BladeEnds ends{tip.end_table().averaged(width), tip.kept_table().averaged(width)};
  for (int i = 0; i <= BristleTable::kSteps; ++i) {
    const double kept = static_cast<double>(ends.takes[i]);
    ends.takes[i] = std::clamp(static_cast<float>(approx::log(kept) / most_scraped), 0.0f, 1.0f);
  }
  return ends;
}

}  // namespace pentimento
