#pragma once
// The interface of paint with air: Fresnel's reflection and the Torrance-Sparrow lobe of its
// roughness (R29, R33). Double precision: the reference of the shader's GLSL. For pictures only.

#include <array>

namespace pentimento {

/// Share of unpolarised light that a smooth dielectric of index `n` > 1 sends back, at cosine
/// `cos_i` in [0,1] of the angle of incidence. Exact (Fresnel).
double fresnel(double cos_i, double n);
/// The same at normal incidence: ((n-1)/(n+1))^2.
double fresnel_normal(double n);
/// Schlick's approximation from the value at normal incidence.
double fresnel_schlick(double cos_i, double f0);

enum class FacetDistribution { kBeckmann, kGgx };

/// Density of facet normals at cosine `n_h` of the angle to the surface's normal; roughness a > 0.
/// Normalised: the integral of D n_h over the hemisphere is 1. 0 for n_h <= 0.
double facet_density(FacetDistribution kind, double n_h, double a);

/// Shadowing and masking of V-shaped grooves (Torrance and Sparrow 1967), in [0,1].
double groove_attenuation(double n_h, double n_v, double n_l, double v_h);

/// D G/(4 (n.l)(n.v)) for unit vectors in the frame of the normal (n = z); 0 when either is below
/// the horizon. Exactly symmetric in l and v.
double facet_lobe(FacetDistribution kind, double a, const std::array<double, 3>& l,
                  const std::array<double, 3>& v);

/// The Torrance-Sparrow BRDF: F(v.h) times the lobe, Fresnel exact for index `n`.
double torrance_sparrow(FacetDistribution kind, double a, double n, const std::array<double, 3>& l,
                        const std::array<double, 3>& v);

}  // namespace pentimento
