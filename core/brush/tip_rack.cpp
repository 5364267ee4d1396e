#include "core/brush/tip_rack.h"

namespace pentimento {

namespace {
constexpr std::size_t kMostTips = 24;  // of some 6 MB; then all are drawn again
}  // namespace

std::shared_ptr<const Tip> TipRack::find(const BrushDefinition& brush) {
  const std::scoped_lock lock(mutex_);
  for (const Entry& entry : entries_)
    if (entry.name == brush.name && entry.shape == brush.shape &&
        entry.bristles == brush.bristles && entry.grip == brush.grip)
      return entry.tip;
  if (entries_.size() >= kMostTips) entries_.clear();
  entries_.push_back(
      {brush.name, brush.shape, brush.bristles, brush.grip, std::make_shared<const Tip>(brush)});
  return entries_.back().tip;
}

}  // namespace pentimento
