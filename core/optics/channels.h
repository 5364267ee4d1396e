#pragma once
// What the channels of a layer mean (A26). Everything that moves, deposits, mixes or merges paint
// treats channels alike, as linear amounts; only optics and the rheology ask this basis. There are
// two kinds of basis: a channel per palette pigment (its amount), or "optical channels" (total
// amount, amount-weighted K and S per band). Both mix exactly alike (Duncan); the cost of optical
// channels does not grow with the palette.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace pentimento {

/// A paint's absorption K and scattering S per band, for optical thickness 1.
struct Pigment {
  std::string name;
  Eigen::VectorXd K;
  Eigen::VectorXd S;
};

/// Turns the channel vector c of a cell into amount-weighted absorption K c, scattering S c and
/// total pigment amount m c.
struct ChannelBasis {
  std::vector<std::string> name;  // per channel
  Eigen::MatrixXd K;              // bands x channels
  Eigen::MatrixXd S;              // bands x channels
  Eigen::VectorXf amount;         // per channel: its share in the total amount (m)
  Eigen::MatrixXf load;           // channels x pigments: the channels of amount 1 of each pigment
  /// Centres of the bands; empty: they are linear red, green and blue.
  std::vector<double> wavelength_nm;
  int channels() const { return static_cast<int>(name.size()); }
  int bands() const { return static_cast<int>(K.rows()); }
};

/// The largest palette that gets one channel per pigment: 8 pigments, or as many as the optical
/// channels that would take their place.
constexpr int most_palette_channels(int bands) {
  return bands > 3 ? 1 + 2 * bands : 8;
}

/// A basis with one channel per pigment.
ChannelBasis palette_channels(const std::vector<Pigment>& palette);
/// A basis of 1 + 2 bands channels, whatever the palette's size: amount, K per band, S per band.
ChannelBasis optical_channels(const std::vector<Pigment>& palette);
/// Palette channels up to most_palette_channels() pigments, optical ones beyond. `wavelength_nm`
/// goes into the basis.
ChannelBasis make_channels(const std::vector<Pigment>& palette,
                           std::vector<double> wavelength_nm = {});

}  // namespace pentimento
