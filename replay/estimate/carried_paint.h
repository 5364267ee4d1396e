#pragma once
// Which channels a brush lays, band by band across its tip: those of its load, and what it took up
// on the way until the load has replaced it. For estimates; nothing is simulated.

#include <array>
#include <cstdint>

#include "core/brush/paint_load.h"

namespace pentimento {

class CarriedPaint {
 public:
  static constexpr int kBands = 8;
  static constexpr int kChannels = 32;

  /// Dipped, on these rows of the tip, into paint of the channels in `mask`. One that is never
  /// dipped, as a knife or a rag, lays only what it took up.
  void dip(std::uint32_t mask, ReservoirRows rows);

  /// The band of the tip coordinate v, -1/2..1/2.
  static int band_of(float v);
  /// The channels that the band holds by its load alone.
  std::uint32_t loaded(int band) const { return loaded_[static_cast<std::size_t>(band)]; }
  /// The channels that the band lays.
  std::uint32_t deposited(int band) const { return deposited_[static_cast<std::size_t>(band)]; }

  /// What a stamp came upon.
  struct Contact {
    std::array<int, kBands> cells{};                       // under the tip
    std::array<std::array<int, kChannels>, kBands> met{};  // of them with the channel wet
    /// A cell under the band, in which the channels of `mask` are wet.
    void add(int band, std::uint32_t mask);
  };
  /// A stamp has lifted the share `pickup_frac` of what it came upon, and the load has replaced
  /// the share `refill_frac` of what the brush held.
  void pass(const Contact& contact, double pickup_frac, double refill_frac);

 private:
  std::array<std::uint32_t, kBands> loaded_{}, deposited_{};
  std::array<std::array<double, kChannels>, kBands> share_{};  // taken up, of what the band holds
};

}  // namespace pentimento
