#include "core/brush/paint_load.h"

#include <algorithm>

#include "core/base/check.h"

namespace pentimento {

ReservoirRows rows_across(float from, float to) {
  PENTIMENTO_CHECK(from >= 0 && from <= to && to <= 1);
  const auto row = [](float at) { return static_cast<int>(at * kReservoirRows + 0.5f); };
  const int begin = std::min(row(from), kReservoirRows - 1);
  return {begin, std::max(begin + 1, row(to))};
}

PaintLoad::PaintLoad(std::span<const float> held, std::span<const float> amount,
                     float height_per_amount_m)
    : paint(held.begin(), held.end()), weight{1} {
  PENTIMENTO_CHECK(held.size() == amount.size() + 1);
  for (const float a : amount) weight.push_back(height_per_amount_m * a);
  const std::size_t padded = (paint.size() + 3) / 4 * 4;
  paint.resize(padded, 0.0f);
  weight.resize(padded, 0.0f);
  volume_m = volume_of(paint.data());
}

void PaintLoad::set_rows(const PaintLoad& other, int begin, int end) {
  PENTIMENTO_CHECK(other.paint.size() == paint.size() && begin >= 0 && end <= kReservoirRows);
  if (rows.empty())
    for (int r = 0; r < kReservoirRows; ++r) rows.insert(rows.end(), paint.begin(), paint.end());
  for (int r = begin; r < end; ++r)
    std::copy(
        other.paint.begin(), other.paint.end(),
        rows.begin() + static_cast<std::ptrdiff_t>(r) * static_cast<std::ptrdiff_t>(paint.size()));
}

}  // namespace pentimento
