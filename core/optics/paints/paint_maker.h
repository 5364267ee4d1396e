#pragma once
// Makes paints: a colour, coefficients, a measurement or a name become K and S in the bands of a
// session, RGB or spectral. The result reaches the state, so no C library functions are used.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/field.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/spectral/measured_paints.h"

namespace pentimento {

/// Colours are linear sRGB as seen through the interface (the model's Saunderson correction); K and
/// S are those of the paint inside it. In spectral optics upsample() turns a picked colour into a
/// spectrum, over white and over black alike.
class PaintMaker {
 public:
  /// RGB without an interface.
  PaintMaker() = default;
  /// The model's optics, bands and interface. A spectral model has a number of bands that
  /// band_wavelengths_nm() knows (checked).
  explicit PaintMaker(const Model& model);
  /// For bands at rising wavelengths, as a dump has them; no wavelengths: RGB.
  PaintMaker(std::vector<double> wavelength_nm, const Saunderson& interface)
      : wavelength_nm_(std::move(wavelength_nm)), interface_(interface) {}

  /// Centres of the bands in nm; empty: linear red, green and blue.
  const std::vector<double>& wavelength_nm() const { return wavelength_nm_; }
  int bands() const { return spectral() ? static_cast<int>(wavelength_nm_.size()) : 3; }

  /// A paint from its colours at optical thickness 1, over a perfect white and over a perfect
  /// black.
  Pigment from_white_black(const std::string& name, std::array<float, 3> over_white,
                           std::array<float, 3> over_black) const;
  /// A paint from one colour. `opacity`: the share of the colour that is left over black, in (0,1).
  Pigment from_color(const std::string& name, std::array<float, 3> color,
                     float opacity = 0.7f) const;
  /// A paint from coefficients of red, green and blue. In spectral optics: the paint of the colours
  /// that these give.
  Pigment from_rgb(const std::string& name, const std::array<double, 3>& K,
                   const std::array<double, 3>& S) const;
  /// A paint from coefficients at rising wavelengths, linear between them and constant beyond. In
  /// RGB: the paint of the colours that these give.
  Pigment from_spectrum(const std::string& name, std::span<const double> wavelength_nm,
                        std::span<const double> K, std::span<const double> S) const;
  /// A pigment of the library; nothing if there is none of that name.
  std::optional<Pigment> from_library(std::string_view name) const;

  /// Reflectance per band, in [0,1], of a substrate that looks like `rgb`.
  std::vector<float> substrate(std::array<float, 3> rgb) const;
  /// The same for a picture's three planes of equal size: one plane per band, values in [0,1].
  /// Spectral: as ColorBases has it.
  std::vector<Field<float>> substrate(const std::array<Field<float>, 3>& rgb) const;

 private:
  bool spectral() const { return !wavelength_nm_.empty(); }
  double inside(double seen) const;
  Pigment in_bands(const std::string& name, const SpectralPaint& paint) const;

  std::vector<double> wavelength_nm_;
  Saunderson interface_;
};

}  // namespace pentimento
