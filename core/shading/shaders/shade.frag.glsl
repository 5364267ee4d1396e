// A pixel: the mean of its samples, each the sum of what the paint scatters and what its interface
// reflects (R33, A32): (1-F) R E/pi + Torrance-Sparrow + F reflection.
uniform float roughness_dry;
uniform float roughness_wet;
uniform float exposure;  // factor on all light

layout(location = 0) out vec4 picture_and_wet;
#ifdef ALBEDO_TARGET
layout(location = ALBEDO_TARGET) out vec4 albedo_and_height;
#endif
#ifdef NORMAL_TARGET
layout(location = NORMAL_TARGET) out vec4 normal_and_depth;
#endif
#ifdef DIFFUSE_TARGET
layout(location = DIFFUSE_TARGET) out vec4 diffuse_light;
#endif
#ifdef SPECULAR_TARGET
layout(location = SPECULAR_TARGET) out vec4 specular_light;
#endif
#ifdef REFLECTION_TARGET
layout(location = REFLECTION_TARGET) out vec4 reflection_light;
#endif
#ifdef PIGMENT_TARGET
layout(location = PIGMENT_TARGET) out vec4 pigment_amounts[PLANES];
#endif

struct Shaded {
  vec3 albedo, normal, diffuse, specular, reflection;
  float height, depth, wet;
  vec4 pigment[PLANES];
};

// Share of the surface that films of this thickness cover: thinner than a tenth of a millimetre
// the canvas's threads stand out.
float covered(float film_m) { return 1.0 - exp(-max(film_m, 0.0) * 1e4); }

void light_up(inout Shaded s, float gloss) {
  vec3 n = s.normal;
  float F = gloss * schlick(n.z);
  float incidence = max(dot(n, lamp_direction), 0.0);
  float roughness = mix(roughness_dry, roughness_wet, s.wet);
  s.diffuse = (1.0 - F) * s.albedo * (ambient(n) + lamp_radiance * incidence) * exposure;
  s.specular = gloss * kPi * lobe(n, roughness) * lamp_radiance * exposure;
  s.reflection = F * reflected(2.0 * n.z * n - vec3(0.0, 0.0, 1.0)) * exposure;
}

Shaded shaded_at(ivec2 sample_index) {
  Place place = place_at(sample_index);
  vec4 ground_texel = read(ground, place);
  Relief surface = relief_at(place);
  Paint paint = paint_at(place);
  Shaded s;
  s.depth = ground_texel.a;
  s.height = surface.height;
  s.normal = normal_of(surface.slope);
  s.albedo = albedo_at(place, paint, s.depth, ground_texel.rgb);
  s.wet = covered(s.depth);
  for (int i = 0; i < PLANES; ++i) {
    s.pigment[i] = vec4(0.0);
    for (int k = 0; k < LAYERS; ++k) s.pigment[i] += paint.amount[k * PLANES + i];
  }
  light_up(s, covered(read(relief, place).g));
  return s;
}

void add(inout Shaded sum, Shaded s) {
  sum.albedo += s.albedo;
  sum.normal += s.normal;
  sum.diffuse += s.diffuse;
  sum.specular += s.specular;
  sum.reflection += s.reflection;
  sum.height += s.height;
  sum.depth += s.depth;
  sum.wet += s.wet;
  for (int i = 0; i < PLANES; ++i) sum.pigment[i] += s.pigment[i];
}

void write(Shaded s, float weight) {
  picture_and_wet = vec4((s.diffuse + s.specular + s.reflection) * weight, s.wet * weight);
#ifdef ALBEDO_TARGET
  albedo_and_height = vec4(s.albedo, s.height) * weight;
#endif
#ifdef NORMAL_TARGET
  normal_and_depth = vec4(normalize(s.normal), s.depth * weight);
#endif
#ifdef DIFFUSE_TARGET
  diffuse_light = vec4(s.diffuse * weight, 0.0);
#endif
#ifdef SPECULAR_TARGET
  specular_light = vec4(s.specular * weight, 0.0);
#endif
#ifdef REFLECTION_TARGET
  reflection_light = vec4(s.reflection * weight, 0.0);
#endif
#ifdef PIGMENT_TARGET
  for (int i = 0; i < PLANES; ++i) pigment_amounts[i] = s.pigment[i] * weight;
#endif
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * SUPERSAMPLE;
  Shaded sum = shaded_at(first);
#if SUPERSAMPLE > 1
  for (int i = 1; i < SUPERSAMPLE * SUPERSAMPLE; ++i) {
    add(sum, shaded_at(first + ivec2(i % SUPERSAMPLE, i / SUPERSAMPLE)));
  }
#endif
  write(sum, 1.0 / float(SUPERSAMPLE * SUPERSAMPLE));
}
