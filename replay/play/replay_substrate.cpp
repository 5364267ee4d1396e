#include "replay/play/replay_substrate.h"

#include <algorithm>
#include <utility>

namespace pentimento {

ReplaySubstrate::ReplaySubstrate(std::unique_ptr<PaperRows> paper, std::vector<float> reflectance,
                                 const CanvasGeometry& fine)
    : paper_(std::move(paper)), reflectance_(std::move(reflectance)), fine_(fine) {}

void ReplaySubstrate::relief_row(int x, int y, std::span<float> out) const {
  paper_->row(x, y, out);
}

void ReplaySubstrate::reflectance_row(int band, int x, int y, std::span<float> out) const {
  const auto index = static_cast<std::size_t>(band);
  if (picture_.empty()) {
    std::fill(out.begin(), out.end(), reflectance_[index]);
    return;
  }
  picture_[index].row(x, y, out);
  for (float& r : out) r = std::clamp(r, 0.0f, 1.0f);
}

void ReplaySubstrate::load(std::vector<Field<float>> bands) {
  picture_.clear();
  for (Field<float>& band : bands)
    picture_.push_back(PictureRows::fitted(std::move(band), fine_.width, fine_.height));
}

}  // namespace pentimento
