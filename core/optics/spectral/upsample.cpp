#include "core/optics/spectral/upsample.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/approx.h"

namespace pentimento {
namespace {

constexpr std::size_t kN = kSpectrumSamples;
constexpr std::size_t kUnknowns = kN + 3;
using Unknowns = std::array<double, kUnknowns>;  // z, then the multipliers
using System = std::array<Unknowns, kUnknowns>;
using RgbTriple = std::array<double, 3>;

const SpectrumWeights& sight() {
  static const SpectrumWeights weights = rgb_weights({});
  return weights;
}

/// Solves a x = b by elimination with partial pivoting; a and b are used up.
Unknowns solve(System& a, Unknowns b) {
  for (std::size_t k = 0; k < kUnknowns; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < kUnknowns; ++i)
      if (a[i][k] * a[i][k] > a[pivot][k] * a[pivot][k]) pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < kUnknowns; ++i) {
      const double factor = a[i][k] / a[k][k];
      if (factor == 0) continue;
      for (std::size_t j = k; j < kUnknowns; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = kUnknowns; k-- > 0;) {
    for (std::size_t j = k + 1; j < kUnknowns; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Row i of the slope's second difference times z: the derivative of half the sum of squares.
double roughness(const Unknowns& z, std::size_t i) {
  double sum = 0;
  if (i > 0) sum += z[i] - z[i - 1];
  if (i + 1 < kN) sum += z[i] - z[i + 1];
  return sum;
}

double pull(const Unknowns& x, std::size_t i) {
  return x[kN] * sight()[0][i] + x[kN + 1] * sight()[1][i] + x[kN + 2] * sight()[2][i];
}

/// The conditions of the minimum, which are 0 there.
Unknowns conditions(const Unknowns& x, const RgbTriple& rgb) {
  Unknowns f{};
  for (std::size_t c = 0; c < 3; ++c) f[kN + c] = -rgb[c];
  for (std::size_t i = 0; i < kN; ++i) {
    const double t = approx::tanh(x[i]);
    f[i] = roughness(x, i) + pull(x, i) * (1 - t * t) / 2;
    for (std::size_t c = 0; c < 3; ++c) f[kN + c] += sight()[c][i] * (t + 1) / 2;
  }
  return f;
}

System derivatives(const Unknowns& x) {
  System a{};
  for (std::size_t i = 0; i < kN; ++i) {
    const double t = approx::tanh(x[i]), slope = (1 - t * t) / 2;
    a[i][i] = (i == 0 || i + 1 == kN ? 1 : 2) - 2 * pull(x, i) * slope * t;
    if (i > 0) a[i][i - 1] = -1;
    if (i + 1 < kN) a[i][i + 1] = -1;
    for (std::size_t c = 0; c < 3; ++c) a[i][kN + c] = a[kN + c][i] = sight()[c][i] * slope;
  }
  return a;
}

double size_of(const Unknowns& f) {
  double sum = 0;
  for (const double v : f) sum += v * v;
  return sum;
}

/// Half the logarithm of the odds: the z of a grey of this reflectance.
double grey(double reflectance) {
  return 0.5 * approx::log(reflectance / (1 - reflectance));
}

}  // namespace

Spectrum upsample(const std::array<double, 3>& rgb) {
  constexpr double kEdge = 0.001, kDone = 1e-20;
  constexpr int kMostSteps = 100, kMostHalvings = 20;
  RgbTriple target = rgb;
  for (double& c : target) c = std::clamp(c, kEdge, 1 - kEdge);
  Unknowns x{};
  std::fill_n(x.begin(), kN, grey((target[0] + target[1] + target[2]) / 3));
  Unknowns f = conditions(x, target);
  for (int step = 0; step < kMostSteps && size_of(f) > kDone; ++step) {
    System a = derivatives(x);
    const Unknowns move = solve(a, f);
    double share = 1;
    for (int i = 0; i <= kMostHalvings; ++i, share /= 2) {
      Unknowns next = x;
      for (std::size_t k = 0; k < kUnknowns; ++k) next[k] -= share * move[k];
      const Unknowns residual = conditions(next, target);
      if (i < kMostHalvings && !(size_of(residual) < size_of(f))) continue;
      x = next;
      f = residual;
      break;
    }
  }
  Spectrum out{};
  for (std::size_t i = 0; i < kN; ++i) out[i] = (approx::tanh(x[i]) + 1) / 2;
  return out;
}

ColorBases::ColorBases() {
  for (std::size_t i = 0; i < basis_.size(); ++i) {
    basis_[i] = upsample({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  }
}

ColorBases::Shares base_shares(const std::array<double, 3>& rgb) {
  // The share that all three components have is white, the share that two of them have is their
  // mixed corner, the rest is a single primary.
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(rgb[a], a) < std::pair(rgb[b], b);
  });
  ColorBases::Shares share{};
  std::size_t corner = 7;
  double below = 0;
  for (const std::size_t c : order) {
    share[corner] += rgb[c] - below;
    below = rgb[c];
    corner &= ~(std::size_t{1} << c);
  }
  share[corner] += 1 - below;
  return share;
}

}  // namespace pentimento
