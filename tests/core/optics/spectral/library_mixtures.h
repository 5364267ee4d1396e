#pragma once
// Paints of the library as tests look at them: opaque mixtures in the bands of a model, their
// colours beside a perfect white.

#include <string>
#include <vector>

#include "core/optics/kubelka_munk.h"
#include "core/optics/paints/paint_maker.h"
#include "core/optics/paints/pigment_library.h"
#include "core/optics/spectral/band_weights.h"
#include "core/optics/spectral/ciede2000.h"

namespace pentimento::mixtures {

inline Model spectral_model(int bands) {
  Model model;
  model.optics = OpticsKind::kSpectral;
  model.bands = bands;
  model.saunderson_k2 = static_cast<float>(kMeasuredK2);
  return model;
}

/// Spectral paint in a light: what it looks like.
class Eye {
 public:
  explicit Eye(int bands, const Viewing& viewing = {})
      : model_(spectral_model(bands)),
        maker_(model_),
        weights_(band_xyz_weights(maker_.wavelength_nm(), viewing)),
        white_(white_xyz(viewing)) {}

  const PaintMaker& maker() const { return maker_; }
  Pigment paint(std::string_view name) const { return *maker_.from_library(name); }

  /// A share of `a` in `b`, as thick as can be.
  Lab opaque(const Pigment& a, const Pigment& b, double share) const {
    return color([&](Eigen::Index i) {
      return km_opaque(
          {share * a.K(i) + (1 - share) * b.K(i), share * a.S(i) + (1 - share) * b.S(i)});
    });
  }
  /// A film of thickness x over a ground of one reflectance, or over `below` as thick as can be.
  Lab film(const Pigment& a, double x, double ground) const {
    return color([&](Eigen::Index i) { return km_over(km_film({a.K(i), a.S(i)}, x), ground); });
  }
  Lab film(const Pigment& a, double x, const Pigment& below) const {
    return color([&](Eigen::Index i) {
      return km_over(km_film({a.K(i), a.S(i)}, x), km_opaque({below.K(i), below.S(i)}));
    });
  }

 private:
  template <typename Inside>
  Lab color(Inside inside) const {
    Eigen::VectorXd seen(maker_.bands());
    for (Eigen::Index i = 0; i < seen.size(); ++i)
      seen(i) = saunderson_seen(inside(i), static_cast<double>(model_.saunderson_k1),
                                static_cast<double>(model_.saunderson_k2));
    const Eigen::Vector3d xyz = (weights_ * seen).cwiseMax(0);
    return lab_of({xyz(0), xyz(1), xyz(2)}, white_);
  }

  Model model_;
  PaintMaker maker_;
  Eigen::Matrix3Xd weights_;
  Xyz white_;
};

/// The largest CIEDE2000 between two eyes over all mixtures of two of `names`.
inline double largest_difference(const Eye& exact, const Eye& few,
                                 const std::vector<std::string>& names) {
  std::vector<Pigment> all, some;
  for (const std::string& name : names) {
    all.push_back(exact.paint(name));
    some.push_back(few.paint(name));
  }
  double largest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
        largest = std::max(largest, ciede2000(exact.opaque(all[i], all[j], share),
                                              few.opaque(some[i], some[j], share)));
      }
    }
  }
  return largest;
}

inline std::vector<std::string> measured_names() {
  std::vector<std::string> names;
  for (const SpectralPaint& paint : measured_paints()) names.push_back(paint.name);
  return names;
}
inline std::vector<std::string> all_names() {
  const auto names = library_pigment_names();
  return {names.begin(), names.end()};
}

}  // namespace pentimento::mixtures
