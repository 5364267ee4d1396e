#pragma once
// Kubelka-Munk: what a film of paint reflects and lets through, from its absorption K and
// scattering S, and the inverse, K and S from the colours of a film. Double precision, for palettes
// and tests; composite.h does whole rows. Pigments reach the state, so no C library functions are
// used. The formulas are written without cancellation or overflow, and are equal to those of Curtis
// et al. 1997, sec. 5.

#include <array>
#include <string>

#include "core/optics/channels.h"

namespace pentimento {

/// Absorption and scattering for optical thickness 1; both >= 0.
struct KmCoefficients {
  double K = 0;
  double S = 0;
};

/// The shares of light that a film reflects (R) and lets through (T), without its interface; in
/// [0,1].
struct KmFilm {
  double R = 0;
  double T = 1;
};

/// Inverse Kubelka-Munk (R30): the paint whose film of thickness 1 looks `over_white` on a perfect
/// white and `over_black` on a perfect black. Domain 0 < over_black < over_white <= 1, checked.
///   a - 1 = (1-Rw)(1-Rb)/(2Rb), b = sqrt((a-1)(a+1)), S = atanh(q)/b, K = S(a-1),
///   q = 2b Rb/((1+Rw)(1-Rb)), 1-q^2 = 4(Rw-Rb)/((1+Rw)^2(1-Rb))
/// Source: Curtis et al. 1997, sec. 5.1, rewritten so that nothing cancels.
KmCoefficients km_from_white_black(double over_white, double over_black);

/// A film of optical thickness x >= 0; x, K, S finite. R + T <= 1 to rounding.
KmFilm km_film(KmCoefficients paint, double x);

/// One film on top of another: R = R1 + T1^2 R2/(1 - R1 R2), T = T1 T2/(1 - R1 R2). Not both R = 1.
KmFilm km_stack(KmFilm top, KmFilm below);

/// Reflectance of a film on a ground of reflectance `ground` in [0,1].
double km_over(KmFilm film, double ground);

/// Reflectance of a film too thick to see through: 1 + q - sqrt(q^2 + 2q), q = K/S; 0 without S.
double km_opaque(KmCoefficients paint);

/// Saunderson's correction: what is seen through the interface of a paint that reflects `inside`.
/// k1: reflection of the interface from outside; k2: from inside (docs/optics.md).
double saunderson_seen(double inside, double k1, double k2);
/// The inverse of saunderson_seen().
double saunderson_inside(double seen, double k1, double k2);

/// A pigment from its colours (linear RGB, optical thickness 1) over white and over black. Colours
/// outside the domain are moved to its edge: over_white into [2/255, 1 - 1/255], over_black into
/// [1/255, over_white - 1e-4].
Pigment pigment_from_white_black(std::string name, std::array<float, 3> over_white,
                                 std::array<float, 3> over_black);

/// A pigment from one picked colour (A25): over_black = opacity x colour, opacity in (0,1).
Pigment pigment_from_color(std::string name, std::array<float, 3> color, float opacity = 0.7f);

}  // namespace pentimento
