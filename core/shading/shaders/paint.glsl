// The layers' Kubelka-Munk colour over the dry reflectance (R31); the twin of optics/composite.cpp.
// Bands are red, green and blue, or wavelengths, four to a texel, which band_color turns into RGB.
#if SPECTRAL
#define Bands vec4
uniform sampler2DArray dry;                 // reflectance of the dry layer
uniform vec3 band_color[4 * BAND_TEXELS];   // linear RGB of a band that reflects all
#else
#define Bands vec3
#endif
uniform Bands absorption[CHANNELS * BAND_TEXELS];  // K per channel amount, texel by texel
uniform Bands scattering[CHANNELS * BAND_TEXELS];  // S per channel amount
uniform vec2 saunderson;            // k1, k2 of the interface
uniform float share[CHANNELS];      // of the channel in the total pigment amount
uniform float per_reference;        // 1 / reference amount, or 1 / reference depth (1/m)

struct Paint {
  vec4 amount[LAYERS * PLANES];
};

Paint paint_at(Place p) {
  Paint paint;
  for (int i = 0; i < LAYERS * PLANES; ++i) paint.amount[i] = read_layer(amounts, i, p);
  return paint;
}

float channel_of(Paint paint, int layer, int c) {
  return paint.amount[layer * PLANES + c / 4][c % 4];
}

float total_of(Paint paint, int layer) {
  float total = 0.0;
  for (int c = 0; c < CHANNELS; ++c) total += share[c] * channel_of(paint, layer, c);
  return total;
}

// A film of absorption Kx and scattering Sx over a ground. The factor exp(-z) keeps cosh from
// overflowing; the series replaces sinh(z)/z where that would cancel.
Bands film_over(Bands Kx, Bands Sx, Bands ground_reflectance) {
  Bands z = sqrt(Kx * (Kx + 2.0 * Sx));
  Bands e = exp(-z);
  Bands t = z * z;
  Bands series = e * (1.0 + t / 6.0 * (1.0 + t / 20.0));
  Bands closed = (1.0 - e * e) / (2.0 * max(z, 0.25));
  Bands w = mix(closed, series, lessThan(z, Bands(0.25)));
  Bands d = 0.5 * (1.0 + e * e) + (Kx + Sx) * w;
  Bands R = Sx * w / d;
  Bands T = e / d;
  return R + T * T * ground_reflectance / max(1.0 - R * ground_reflectance, 1e-7);
}

// What K c and S c of each layer are multiplied with; 0 for an empty layer.
float[LAYERS] layer_factors(Paint paint, float depth_m) {
  float total[LAYERS];
  float occupied = 0.0;
  for (int k = 0; k < LAYERS; ++k) {
    total[k] = total_of(paint, k);
    occupied += total[k] > EMPTY_AMOUNT ? 1.0 : 0.0;
  }
  float factor[LAYERS];
  for (int k = 0; k < LAYERS; ++k) {
#if BY_DEPTH
    float thickness = depth_m / occupied * per_reference / total[k];
#else
    float thickness = per_reference;
#endif
    factor[k] = total[k] <= EMPTY_AMOUNT ? 0.0 : thickness;
  }
  return factor;
}

// One texel of bands of all layers over the dry reflectance, as seen through the interface.
Bands composite(Paint paint, float factor[LAYERS], int texel, Bands dry_reflectance) {
  Bands reflectance = dry_reflectance;
  for (int k = 0; k < LAYERS; ++k) {
    if (factor[k] == 0.0) continue;
    Bands K = Bands(0.0), S = Bands(0.0);
    for (int c = 0; c < CHANNELS; ++c) {
      float amount = channel_of(paint, k, c);
      K += absorption[c * BAND_TEXELS + texel] * amount;
      S += scattering[c * BAND_TEXELS + texel] * amount;
    }
    reflectance = film_over(max(K * factor[k], 0.0), max(S * factor[k], 0.0), reflectance);
  }
  reflectance = clamp(reflectance, 0.0, 1.0);
#if INTERFACE
  reflectance = saunderson.x + (1.0 - saunderson.x) * (1.0 - saunderson.y) * reflectance /
                                   (1.0 - saunderson.y * reflectance);
#endif
  return reflectance;
}

vec3 albedo_at(Place place, Paint paint, float depth_m, vec3 dry_color) {
  float factor[LAYERS] = layer_factors(paint, depth_m);
#if SPECTRAL
  vec3 rgb = vec3(0.0);
  for (int b = 0; b < BAND_TEXELS; ++b) {
    vec4 R = composite(paint, factor, b, read_layer(dry, b, place));
    for (int i = 0; i < 4; ++i) rgb += band_color[4 * b + i] * R[i];
  }
  return rgb;
#else
  return composite(paint, factor, 0, dry_color);
#endif
}
