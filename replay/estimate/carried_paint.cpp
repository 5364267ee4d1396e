#include "replay/estimate/carried_paint.h"

#include <algorithm>
#include <bit>

namespace pentimento {

namespace {
// A stamp lays a fortieth of a film, some 4e-4 of an amount; less than half a quantum of it,
// 1.2e-7, is rounded away (core/fluid/conservative/tiles/quantum.h).
constexpr double kLeastShare = 3e-4;
}  // namespace

int CarriedPaint::band_of(float v) {
  return std::clamp(static_cast<int>((v + 0.5f) * kBands), 0, kBands - 1);
}

void CarriedPaint::dip(std::uint32_t mask, ReservoirRows rows) {
  static_assert(kReservoirRows % kBands == 0);
  constexpr int kRows = kReservoirRows / kBands;  // of a band
  const int begin = rows.begin / kRows, end = (rows.end + kRows - 1) / kRows;
  for (int band = begin; band < end; ++band) {
    const auto b = static_cast<std::size_t>(band);
    loaded_[b] = deposited_[b] = mask;
    share_[b] = {};
  }
}

void CarriedPaint::Contact::add(int band, std::uint32_t mask) {
  const auto b = static_cast<std::size_t>(band);
  ++cells[b];
  for (; mask != 0; mask &= mask - 1) ++met[b][static_cast<std::size_t>(std::countr_zero(mask))];
}

void CarriedPaint::pass(const Contact& contact, double pickup_frac, double refill_frac) {
  for (int band = 0; band < kBands; ++band) {
    const auto b = static_cast<std::size_t>(band);
    if (contact.cells[b] == 0) continue;
    deposited_[b] = loaded(band);
    for (std::size_t c = 0; c < kChannels; ++c) {
      double& share = share_[b][c];
      const double met = static_cast<double>(contact.met[b][c]) / contact.cells[b];
      share += pickup_frac * met * (1 - share);
      share *= 1 - refill_frac;
      if (share > kLeastShare) deposited_[b] |= std::uint32_t{1} << c;
    }
  }
}

}  // namespace pentimento
