// A pixel: the mean of its samples, each the sum of what the paint scatters and what its interface
// reflects (R33, A32): (1-F) R E/pi + Torrance-Sparrow + F reflection.
uniform float roughness_dry;
uniform float roughness_wet;
uniform float varnish;   // share of a smooth clear coat
uniform mat3 exposure;   // of all light: factor and white balance
#if OCCLUSION_PLANES > 0
uniform float occlusion;  // strength
uniform sampler2D seen_first;
#if OCCLUSION_PLANES > 1
uniform sampler2D seen_second;
#endif
#endif

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
#ifdef PIGMENT_TARGET
  vec4 pigment[PLANES];
#endif
};

// Share of the surface that films of this thickness cover: thinner than a tenth of a millimetre
// the canvas's threads stand out.
float covered(float film_m) { return 1.0 - exp(-max(film_m, 0.0) * 1e4); }

// Shares of the sky and of the lamps that the relief leaves: horizon.h.
struct Seen {
  float sky;
  float lamp[LAMPS + 1];
};

Seen seen_at(Place p) {
  Seen seen;
  seen.sky = 1.0;
  for (int i = 0; i < LAMPS + 1; ++i) seen.lamp[i] = 1.0;
#if OCCLUSION_PLANES > 0
  vec4 first = mix(vec4(1.0), read(seen_first, p), occlusion);
  seen.sky = first.r;
  for (int i = 0; i < min(LAMPS, 3); ++i) seen.lamp[i] = first[i + 1];
#endif
#if OCCLUSION_PLANES > 1
  vec4 second = mix(vec4(1.0), read(seen_second, p), occlusion);
  for (int i = 3; i < LAMPS; ++i) seen.lamp[i] = second[i - 3];
#endif
  return seen;
}

// Light that the walls of a furrow throw back into it, in their own colour: the cubic of Jimenez,
// Wu, Pesce and Jarabo 2016.
vec3 with_walls(float sky, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
  return clamp(((sky * a + b) * sky + c) * sky, sky, 1.0);
}

// `smooth_share`: how far wet paint has flowed smooth.
void light_up(inout Shaded s, vec3 point, Seen seen, float paint, float smooth_share) {
  vec3 n = s.normal;
  float gloss = mix(paint, 1.0, varnish);
  float smoothness = mix(smooth_share, 1.0, varnish);
  float roughness = mix(roughness_dry, roughness_wet, smoothness);
  float per_a2 = 1.0 / (roughness * roughness);
  float F = gloss * schlick(n.z);
  vec3 light = ambient(n) * with_walls(seen.sky, s.albedo);
  s.specular = vec3(0.0);
#if LAMPS > 0
  for (int i = 0; i < LAMPS; ++i) {
    Lit lamp = lamp_at(i, point);
    vec3 radiance = lamp.radiance * seen.lamp[i];
    float n_l = dot(n, lamp.direction);
    Facets facets = Facets(lamp_facets[i], lamp_mirror[i].x, lamp_mirror[i].y);
    if (lamp_range2[i] != 0.0) facets = facets_of(lamp.direction);
    light += radiance * max(n_l, 0.0);
    s.specular += radiance * lobe(n, n_l, facets, per_a2);
  }
#endif
  s.diffuse = exposure * ((1.0 - F) * s.albedo * light);
  s.specular = exposure * (gloss * kPi * s.specular);
  vec3 mirrored = 2.0 * n.z * n - vec3(0.0, 0.0, 1.0);
  vec3 reflected = surroundings(n, mirrored, smoothness, roughness);
#if REFLECTION_MAP
  reflected = mix(reflected, in_camera(mirrored), mix(s.wet, 1.0, varnish));
#endif
  s.reflection = exposure * (F * seen.sky * reflected);
}

Shaded shaded_at(ivec2 sample_index) {
  Place place = place_at(sample_index);
  vec4 ground_texel = read(ground, place);
  Relief surface = relief_at(place);
  Shaded s;
  s.depth = ground_texel.a;
  s.height = surface.height;
  s.normal = normal_of(surface.slope);
  s.albedo = ground_texel.rgb;
  // A thin film still has the shape of the threads and of the paint that it lies on: it takes four
  // times the depth to flow smooth that it takes to cover.
  float rough_share = exp(-max(s.depth, 0.0) * 2.5e3);
  float rough2 = rough_share * rough_share;
  s.wet = 1.0 - rough2 * rough2;
#ifdef PIGMENT_TARGET
  for (int i = 0; i < PLANES; ++i) s.pigment[i] = read_layer(amounts, i, place);
#endif
  vec3 point = point_at(place.cell, place.fraction, s.height);
  Seen seen = seen_at(place);
  float paint = covered(paint_m(place));
#if RELIEF_SAMPLES > 1
  // The mean light of the cell's quarters, each with the slope of its own.
  vec2 slopes[4];
  slopes_in_cell(place, slopes);
  vec3 normal = vec3(0.0), diffuse = vec3(0.0), specular = vec3(0.0), reflection = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    s.normal = normal_of(slopes[i]);
    light_up(s, point, seen, paint, 1.0 - rough_share);
    normal += s.normal;
    diffuse += s.diffuse;
    specular += s.specular;
    reflection += s.reflection;
  }
  s.normal = normalize(normal);
  s.diffuse = 0.25 * diffuse;
  s.specular = 0.25 * specular;
  s.reflection = 0.25 * reflection;
#else
  light_up(s, point, seen, paint, 1.0 - rough_share);
#endif
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
#ifdef PIGMENT_TARGET
  for (int i = 0; i < PLANES; ++i) sum.pigment[i] += s.pigment[i];
#endif
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
