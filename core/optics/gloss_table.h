#pragma once
// A table of what glossy paint shows of a light probe. The viewer looks straight at the canvas, so
// the gloss follows from the normal and the roughness alone, and one table per probe is enough. For
// pictures only.

#include <array>
#include <vector>

#include "core/base/field.h"
#include "core/base/threads.h"

namespace pentimento {

/// Red, green and blue of an equirectangular panorama (irradiance.h), linear.
using Panorama = std::array<FieldView<const float>, 3>;

struct GlossTable {
  static constexpr int kSide = 64;
  static constexpr int kLevels = 8;
  /// Level, row, column, then red, green, blue. Texel (i, j) is of the normal with
  /// x = (2i + 1)/kSide - 1 and y = (2j + 1)/kSide - 1, level k of the roughness
  /// dry + (wet - dry) k/(kLevels - 1).
  std::vector<float> rgb;
};

/// The interface whose gloss the table holds. Roughness is a of Beckmann's distribution, > 0.
struct GlossSurface {
  float roughness_dry = 0;
  float roughness_wet = 0;
  float refractive_index = 0;
};

/// Mean radiance over the lobe.
///   T(n, a) = int L(l) f(n, l; a) n.l dl / int f(n, l; a) n.l dl,  f: Torrance-Sparrow, v =
///   (0,0,1)
/// Scheme: sums over the panorama's pixels, halved while they stay finer than 0.4 a; a surface
/// smoother than the pixels are fine mirrors the nearest four. Stable: a mean with weights >=
/// 0. Source: R33, R34; microfacet.h. Departs from it: facets steeper than 4 a are left out
/// (e^-16); normals steeper than 0.98 count as that. Energy: of a panorama that is the same
/// everywhere, that radiance.
GlossTable make_gloss_table(const Panorama& probe, const GlossSurface& surface,
                            const Threads& threads);

}  // namespace pentimento
