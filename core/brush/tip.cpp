#include "core/brush/tip.h"

#include <algorithm>

#include "core/brush/resample.h"

namespace pentimento {

namespace {
constexpr int kMasterSize = 256;  // a tip of 30 mm has texels of 0.12 mm, a hair's width

/// FNV-1a of the name.
std::uint64_t seed_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}
}  // namespace

TipLevel::TipLevel(const Field<float>& map)
    : size_(map.width()), padded_(map.width() + 2, map.width() + 2) {
  for (int y = 0; y < size_; ++y) std::copy_n(map.row(y), size_, padded_.row(y + 1) + 1);
}

Tip::Tip(const BrushDefinition& brush) : extent_(tip_extent(brush.shape)) {
  const std::uint64_t seed = seed_of(brush.name);
  const Field<float> master = draw_tip(brush, kMasterSize, seed);
  double sum = 0;
  for (int y = 0; y < kMasterSize; ++y)
    for (int x = 0; x < kMasterSize; ++x) sum += static_cast<double>(master(x, y));
  mean_ = static_cast<float>(sum / (kMasterSize * kMasterSize));
  for (const int size : {256, 181, 128, 91, 64, 45, 32, 23, 16, 11, 8, 6, 4, 3, 2})
    levels_.emplace_back(resample_area(master, size, size));
  for (std::size_t i = 0; i < grip_.size(); ++i)
    grip_[i] = hair_grip(brush.shape, 2 * static_cast<float>(i) / kGripSteps - 1, seed);
  if (mean_ > 0) list_texels(resample_area(master, kReservoirColumns, kReservoirRows));
}

void Tip::list_texels(const Field<float>& map) {
  constexpr int kColumns = kReservoirColumns, kRows = kReservoirRows;
  const auto centre = [](int i, int n) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
  };
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      float value = 0;
      for (int j = std::max(0, y - 1); j <= std::min(kRows - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(kColumns - 1, x + 1); ++i)
          value = std::max(value, map(i, j));
      if (!(value > 0)) continue;
      const int index = y * kColumns + x;
      texels_.push_back(
          {index, centre(x, kColumns), centre(y, kRows), std::min(1.0f, value / mean_)});
      covered_[static_cast<std::size_t>(index)] = 1;
    }
  }
}

const TipLevel& Tip::level_for(float cell_frac) const {
  // Half-octave steps: the next coarser level is nearer once a texel is 2^(1/4) too fine.
  constexpr float kHalfStep = 1.18920712f;
  for (const TipLevel& level : levels_)
    if (cell_frac * static_cast<float>(level.size()) <= kHalfStep) return level;
  return levels_.back();
}

}  // namespace pentimento
