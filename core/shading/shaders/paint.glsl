// The layers' Kubelka-Munk colour over the dry reflectance (R31); the twin of optics/composite.cpp.
uniform vec3 absorption[CHANNELS];  // K per channel amount
uniform vec3 scattering[CHANNELS];  // S per channel amount
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
vec3 film_over(vec3 Kx, vec3 Sx, vec3 ground_reflectance) {
  vec3 z = sqrt(Kx * (Kx + 2.0 * Sx));
  vec3 e = exp(-z);
  vec3 t = z * z;
  vec3 series = e * (1.0 + t / 6.0 * (1.0 + t / 20.0));
  vec3 closed = (1.0 - e * e) / (2.0 * max(z, 0.25));
  vec3 w = mix(closed, series, lessThan(z, vec3(0.25)));
  vec3 d = 0.5 * (1.0 + e * e) + (Kx + Sx) * w;
  vec3 R = Sx * w / d;
  vec3 T = e / d;
  return R + T * T * ground_reflectance / max(1.0 - R * ground_reflectance, 1e-7);
}

vec3 composite(Paint paint, float depth_m, vec3 dry_reflectance) {
  float total[LAYERS];
  float occupied = 0.0;
  for (int k = 0; k < LAYERS; ++k) {
    total[k] = total_of(paint, k);
    occupied += total[k] > EMPTY_AMOUNT ? 1.0 : 0.0;
  }
  vec3 reflectance = dry_reflectance;
  for (int k = 0; k < LAYERS; ++k) {
    if (total[k] <= EMPTY_AMOUNT) continue;
#if BY_DEPTH
    float factor = depth_m / occupied * per_reference / total[k];
#else
    float factor = per_reference;
#endif
    vec3 K = vec3(0.0), S = vec3(0.0);
    for (int c = 0; c < CHANNELS; ++c) {
      float amount = channel_of(paint, k, c);
      K += absorption[c] * amount;
      S += scattering[c] * amount;
    }
    reflectance = film_over(max(K * factor, 0.0), max(S * factor, 0.0), reflectance);
  }
  return clamp(reflectance, 0.0, 1.0);
}
