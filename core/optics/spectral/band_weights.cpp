#include "core/optics/spectral/band_weights.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "core/optics/kubelka_munk.h"
#include "core/optics/spectral/bands.h"
#include "core/optics/spectral/ciede2000.h"
#include "core/optics/spectral/measured_paints.h"
#include "core/optics/spectral/upsample.h"

namespace pentimento {
namespace {

double seen(double inside) {
  return saunderson_seen(inside, 0, kMeasuredK2);
}

/// Paints as thick as can be, or as a film of thickness 1 over a ground.
struct Example {
  Spectrum K, S;
  double ground;  // below 0: opaque
};

double reflectance(const Example& e, double K, double S) {
  const KmCoefficients paint{K, S};
  return seen(e.ground < 0 ? km_opaque(paint) : km_over(km_film(paint, 1), e.ground));
}

Spectrum between(const Spectrum& a, const Spectrum& b, double share) {
  Spectrum out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] + (b[i] - a[i]) * share;
  return out;
}

void add_measured(std::vector<Example>& examples) {
  const std::span<const SpectralPaint> paints = measured_paints();
  for (std::size_t i = 0; i < paints.size(); ++i) {
    for (const double ground : {-1.0, 0.0, 1.0})
      examples.push_back({paints[i].K, paints[i].S, ground});
    for (std::size_t j = 0; j < i; ++j) {
      for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9})
        examples.push_back({between(paints[i].K, paints[j].K, share),
                            between(paints[i].S, paints[j].S, share), -1});
    }
  }
}

/// Smooth colours across sRGB, as opaque paints that scatter alike.
void add_smooth(std::vector<Example>& examples) {
  for (int i = 0; i < 27; ++i) {
    const int red = i % 3, green = i / 3 % 3, blue = i / 9;
    const Spectrum color = upsample({red / 2.0, green / 2.0, blue / 2.0});
    Example e{{}, {}, -1};
    e.S.fill(1);
    for (std::size_t s = 0; s < color.size(); ++s) {
      const double inside = saunderson_inside(color[s], 0, kMeasuredK2);
      e.K[s] = (1 - inside) * (1 - inside) / (2 * inside);
    }
    examples.push_back(e);
  }
}

using XyzWeights = Eigen::Matrix<double, 3, kSpectrumSamples>;

/// What the examples reflect in the bands, and what they look like: a column each.
struct SeenColor {
  Eigen::MatrixXd bands;
  Eigen::Matrix3Xd xyz;
};
SeenColor see(std::span<const double> wavelength_nm, const XyzWeights& exact) {
  std::vector<Example> examples;
  add_measured(examples);
  add_smooth(examples);
  const auto n = static_cast<Eigen::Index>(wavelength_nm.size());
  const auto count = static_cast<Eigen::Index>(examples.size());
  SeenColor seen{Eigen::MatrixXd(n, count), Eigen::Matrix3Xd(3, count)};
  Eigen::Vector<double, kSpectrumSamples> all;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Example& e = examples[static_cast<std::size_t>(k)];
    for (int i = 0; i < kSpectrumSamples; ++i) {
      const auto s = static_cast<std::size_t>(i);
      all(i) = reflectance(e, e.K[s], e.S[s]);
    }
    seen.xyz.col(k) = exact * all;
    const std::vector<double> K = sampled_at(e.K, wavelength_nm);
    const std::vector<double> S = sampled_at(e.S, wavelength_nm);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto b = static_cast<std::size_t>(i);
      seen.bands(i, k) = reflectance(e, K[b], S[b]);
    }
  }
  return seen;
}

/// The weights of least square error, where example k counts share(k); exact for the white.
Eigen::Matrix3Xd fitted(const SeenColor& seen, const Eigen::VectorXd& share,
                        const Eigen::Vector3d& white) {
  const Eigen::MatrixXd weighed = seen.bands * share.asDiagonal();
  Eigen::MatrixXd squares = weighed * seen.bands.transpose();
  const Eigen::Index n = squares.rows();
  squares.diagonal().array() += 1e-9 * squares.trace() / static_cast<double>(n);
  const Eigen::LDLT<Eigen::MatrixXd> factors(squares);
  Eigen::Matrix3Xd weights = factors.solve(weighed * seen.xyz.transpose()).transpose();
  // The least change that makes the white exact.
  const Eigen::VectorXd along = factors.solve(Eigen::VectorXd::Ones(n));
  weights += (white - weights.rowwise().sum()) * along.transpose() / along.sum();
  return weights;
}

Eigen::VectorXd differences(const SeenColor& seen, const Eigen::Matrix3Xd& weights,
                            const Eigen::Vector3d& white) {
  const auto lab = [&](const Eigen::Vector3d& xyz) {
    return lab_of({xyz(0), xyz(1), xyz(2)}, {white(0), white(1), white(2)});
  };
  const Eigen::Matrix3Xd got = (weights * seen.bands).cwiseMax(0);
  Eigen::VectorXd out(got.cols());
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out(k) = ciede2000(lab(got.col(k)), lab(seen.xyz.col(k)));
  return out;
}

/// Fits again and again, counting more what differs most: towards the smallest largest difference.
Eigen::Matrix3Xd evened_out(const SeenColor& seen, const Eigen::Vector3d& white) {
  constexpr int kRounds = 12;
  constexpr double kBlack = 0.005;  // below this errors are seen no better
  Eigen::VectorXd share = (seen.xyz.row(1).array() + kBlack).pow(-4.0 / 3).transpose();
  Eigen::Matrix3Xd best;
  double least = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix3Xd weights = fitted(seen, share, white);
    const Eigen::VectorXd difference = differences(seen, weights, white);
    const double largest = difference.maxCoeff();
    if (round == 0 || largest < least) {
      best = weights;
      least = largest;
    }
    share.array() *= 0.3 + difference.array() / largest;
  }
  return best;
}

bool is_whole_spectrum(std::span<const double> wavelength_nm) {
  const std::vector<double> all = band_wavelengths_nm(kSpectrumSamples);
  return std::equal(all.begin(), all.end(), wavelength_nm.begin(), wavelength_nm.end());
}

}  // namespace

Eigen::Matrix3Xd band_xyz_weights(std::span<const double> wavelength_nm, const Viewing& viewing) {
  const SpectrumWeights table = xyz_weights(viewing);
  XyzWeights exact;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < kSpectrumSamples; ++i)
      exact(c, i) = table[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)];
  if (is_whole_spectrum(wavelength_nm)) return exact;
  return evened_out(see(wavelength_nm, exact), exact.rowwise().sum());
}

Eigen::Matrix3Xd band_rgb_weights(std::span<const double> wavelength_nm, const Viewing& viewing) {
  const Matrix3 to_rgb = xyz_to_rgb(white_xyz(viewing));
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m(i, j) = to_rgb[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return m * band_xyz_weights(wavelength_nm, viewing);
}

}  // namespace pentimento
