#include "core/optics/paints/paint_maker.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/optics/kubelka_munk.h"
#include "core/optics/paints/pigment_library.h"
#include "core/optics/spectral/bands.h"
#include "core/optics/spectral/spectrum_to_rgb.h"
#include "core/optics/spectral/upsample.h"

namespace pentimento {
namespace {

constexpr double kDarkest = 1.0 / 255, kLeastDifference = 1e-4;

Eigen::VectorXd to_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::array<double, 3> to_double(std::array<float, 3> rgb) {
  return {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
}

const ColorBases& color_bases() {
  static const ColorBases bases;
  return bases;
}

}  // namespace

PaintMaker::PaintMaker(const Model& model)
    : interface_{static_cast<double>(model.saunderson_k1),
                 static_cast<double>(model.saunderson_k2)} {
  if (model.optics == OpticsKind::kRgb) return;
  wavelength_nm_ = band_wavelengths_nm(model.bands);
  PENTIMENTO_CHECK(spectral());
}

double PaintMaker::inside(double seen) const {
  if (interface_.none()) return seen;
  return std::clamp(saunderson_inside(seen, interface_.k1, interface_.k2), 0.0, 1.0);
}

Pigment PaintMaker::in_bands(const std::string& name, const SpectralPaint& paint) const {
  return {name, to_vector(sampled_at(paint.K, wavelength_nm_)),
          to_vector(sampled_at(paint.S, wavelength_nm_))};
}

Pigment PaintMaker::from_white_black(const std::string& name, std::array<float, 3> over_white,
                                     std::array<float, 3> over_black) const {
  if (!spectral()) {
    for (std::size_t i = 0; i < 3; ++i) {
      over_white[i] = static_cast<float>(inside(static_cast<double>(over_white[i])));
      over_black[i] = static_cast<float>(inside(static_cast<double>(over_black[i])));
    }
    return pigment_from_white_black(name, over_white, over_black);
  }
  std::array<double, 3> white = to_double(over_white), left{};
  for (std::size_t i = 0; i < 3; ++i) {
    white[i] = std::clamp(white[i], 2 * kDarkest, 1 - kDarkest);
    left[i] = static_cast<double>(over_black[i]) / white[i];
  }
  const Spectrum w = upsample(white), share = upsample(left);
  SpectralPaint paint;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double over_w = std::clamp(inside(w[i]), 2 * kLeastDifference, 1 - kLeastDifference);
    const double over_b =
        std::clamp(inside(w[i] * share[i]), kLeastDifference, over_w - kLeastDifference);
    const KmCoefficients km = km_from_white_black(over_w, over_b);
    paint.K[i] = km.K;
    paint.S[i] = km.S;
  }
  return in_bands(name, paint);
}

Pigment PaintMaker::from_color(const std::string& name, std::array<float, 3> color,
                               float opacity) const {
  std::array<float, 3> over_black{};
  for (std::size_t i = 0; i < 3; ++i) over_black[i] = opacity * color[i];
  return from_white_black(name, color, over_black);
}

Pigment PaintMaker::from_rgb(const std::string& name, const std::array<double, 3>& K,
                             const std::array<double, 3>& S) const {
  if (!spectral())
    return {name, Eigen::Vector3d(K[0], K[1], K[2]), Eigen::Vector3d(S[0], S[1], S[2])};
  std::array<float, 3> white{}, black{};
  for (std::size_t i = 0; i < 3; ++i) {
    const KmFilm film = km_film({K[i], S[i]}, 1);
    white[i] = static_cast<float>(km_over(film, 1));
    black[i] = static_cast<float>(film.R);
  }
  return from_white_black(name, white, black);
}

Pigment PaintMaker::from_spectrum(const std::string& name, std::span<const double> wavelength_nm,
                                  std::span<const double> K, std::span<const double> S) const {
  if (!spectral()) return pigment_from_spectrum(name, {wavelength_nm, K, S});
  std::vector<double> k, s;
  for (const double nm : wavelength_nm_) {
    k.push_back(at_wavelength(wavelength_nm, K, nm));
    s.push_back(at_wavelength(wavelength_nm, S, nm));
  }
  return {name, to_vector(k), to_vector(s)};
}

std::optional<Pigment> PaintMaker::from_library(std::string_view name) const {
  const std::string wanted(name);
  if (const SpectralPaint* paint = find_measured_paint(name)) {
    if (spectral()) return in_bands(wanted, *paint);
    std::vector<double> nm;
    for (int i = 0; i < kSpectrumSamples; ++i) nm.push_back(spectrum_wavelength_nm(i));
    // The paints were measured through an interface, so they are seen through it even if the model
    // has none.
    return pigment_from_spectrum(wanted, {nm, paint->K, paint->S},
                                 {0, interface_.none() ? kMeasuredK2 : 0});
  }
  const Pigment* known = find_library_pigment(name);
  if (known == nullptr) return std::nullopt;
  return from_rgb(wanted, {known->K(0), known->K(1), known->K(2)},
                  {known->S(0), known->S(1), known->S(2)});
}

std::vector<float> PaintMaker::substrate(std::array<float, 3> rgb) const {
  std::vector<float> out;
  if (!spectral()) {
    for (const float r : rgb)
      out.push_back(interface_.none() ? r : static_cast<float>(inside(static_cast<double>(r))));
    return out;
  }
  for (const double r : sampled_at(upsample(to_double(rgb)), wavelength_nm_))
    out.push_back(static_cast<float>(inside(r)));
  return out;
}

std::vector<Field<float>> PaintMaker::substrate(const std::array<Field<float>, 3>& rgb) const {
  const int width = rgb[0].width(), height = rgb[0].height();
  std::vector<Field<float>> planes;
  for (int b = 0; b < bands(); ++b) planes.emplace_back(width, height);
  std::array<std::vector<double>, ColorBases::kCount> basis;
  if (spectral())
    for (std::size_t i = 0; i < basis.size(); ++i)
      basis[i] = sampled_at(color_bases().basis(i), wavelength_nm_);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<double, 3> color{};
      for (std::size_t c = 0; c < 3; ++c)
        color[c] = std::clamp(static_cast<double>(rgb[c](x, y)), 0.0, 1.0);
      const auto share = spectral() ? base_shares(color) : ColorBases::Shares{};
      for (std::size_t b = 0; b < planes.size(); ++b) {
        double seen = spectral() ? 0 : color[b];
        for (std::size_t i = 0; spectral() && i < basis.size(); ++i) seen += share[i] * basis[i][b];
        planes[b](x, y) = static_cast<float>(inside(seen));
      }
    }
  }
  return planes;
}

}  // namespace pentimento
