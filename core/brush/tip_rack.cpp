#include "core/brush/tip_rack.h"

#include <algorithm>

namespace pentimento {

namespace {
constexpr std::size_t kMostTips = 24;  // of some 6 MB; then all are drawn again

bool equal(const Field<float>& a, const Field<float>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y)
    if (!std::equal(a.row(y), a.row(y) + a.width(), b.row(y))) return false;
  return true;
}
}  // namespace

std::shared_ptr<const Tip> TipRack::find(const BrushDefinition& brush) {
  const std::scoped_lock lock(mutex_);
  for (const Entry& entry : entries_)
    if (entry.name == brush.name && entry.shape == brush.shape &&
        entry.bristles == brush.bristles && entry.grip == brush.grip &&
        equal(entry.texture, brush.texture))
      return entry.tip;
  if (entries_.size() >= kMostTips) entries_.clear();
  entries_.push_back({brush.name, brush.shape, brush.texture.clone(), brush.bristles, brush.grip,
                      std::make_shared<const Tip>(brush)});
  return entries_.back().tip;
}

}  // namespace pentimento
