#pragma once
// Albedo: the colour of a row of cells, wet layers over the dry reflectance, band by band, as red,
// green and blue. For pictures; it is tested against optics/composite.h, which computes what dries
// into the state.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/composite.h"

namespace pentimento {

/// What the colour of paint depends on.
struct AlbedoOptics {
  CompositeOptics paint;
  Eigen::Matrix3Xf rgb;  // linear light of a band that reflects all
  float k1 = 0, k2 = 0;  // Saunderson's correction
};
AlbedoOptics make_albedo_optics(const ChannelBasis& basis, const Model& model);

/// A row of cells; all of one length.
struct AlbedoCells {
  std::span<const float> depth_m;
  std::vector<const float*> dry;     // per band
  std::vector<const float*> amount;  // layer by layer, channel by channel; none: no wet paint
  std::span<const float> coverage;   // the share that wet paint covers, in (0, 1]; none: all 1
};

/// Writes four floats per cell: linear red, green and blue, then the depth (m).
///   per layer K x, S x as in optics/composite.h; z = sqrt(Kx (Kx + 2 Sx)), q = 1 - exp(-2z),
///   d = z (1 + exp(-2z)) + (Kx + Sx) q, s = Sx q, t = 2 z exp(-z)
///   R over g = (s (d - s g) + t^2 g) / (d (d - s g))
///   where paint covers the share c < 1: K x / c and S x / c, and R = partly_covered() of the dry
///   reflectance and this R (optics/edge_coverage.h)
///   seen = k1 + (1-k1)(1-k2) R/(1-k2 R), light = sum over bands of rgb times seen
/// Scheme: pointwise, a band of all layers at a time. Stable: R in [0,1] for any finite amounts.
/// Source: R31; Kubelka-Munk (Curtis et al. 1997, sec. 5.2), R = s/d and T = t/d, with one
/// division. Departs from it: z at least 0.002 and, in the exponential, at most 40: both below 3e-6
/// of R.
void albedo_row(const AlbedoOptics& optics, const AlbedoCells& cells, std::span<float> texels);

}  // namespace pentimento
