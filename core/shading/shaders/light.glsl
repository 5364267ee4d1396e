// What falls on the surface and what its interface sends back (R29, R32-R34). The viewer looks
// along -z, so v = (0,0,1). Lamps: lamps.glsl.
uniform vec3 environment[9];   // radiance coefficients L00 L1-1 L10 L11 L2-2 L2-1 L20 L21 L22
uniform float refractive_index;
uniform float normal_reflectance;  // Fresnel at normal incidence
#if REFLECTION_MAP
uniform sampler2D reflection_map;
uniform vec2 reflection_scale;  // picture coordinates per tangent of the angle off the axis
#endif

#if PROBE
uniform sampler2DArray gloss_table;  // of normals, from dry to wet: optics/gloss_table.h
#endif

const float kPi = 3.14159265358979;

// Sum over the bands, each with its factor.
vec3 harmonics(vec3 d, float first, float second, float third) {
  vec3 linear = environment[1] * d.y + environment[2] * d.z + environment[3] * d.x;
  vec3 square = 1.0925484305920792 *
                (environment[4] * (d.x * d.y) + environment[5] * (d.y * d.z) +
                 environment[7] * (d.x * d.z));
  square += environment[6] * (0.31539156525252005 * (3.0 * d.z * d.z - 1.0));
  square += environment[8] * (0.5462742152960396 * (d.x * d.x - d.y * d.y));
  vec3 sum = first * 0.28209479177387814 * environment[0] + second * 0.4886025119029199 * linear +
             third * square;
  return max(sum, 0.0);
}

// Irradiance / pi (Ramamoorthi and Hanrahan 2001).
vec3 ambient(vec3 n) { return harmonics(n, 1.0, 2.0 / 3.0, 0.25); }

// Radiance that comes from about direction r, as a rough surface mirrors it: facets of slope a damp
// band l by exp(-(a l)^2) (Ramamoorthi and Hanrahan 2002, 3.3).
vec3 blurred(vec3 r, float roughness) {
  float damping = exp(-roughness * roughness);
  float squared = damping * damping;
  return harmonics(r, 1.0, damping, squared * squared);
}

// The surroundings in the gloss of normal n: between two levels of the light probe's table, from
// rough (`smoothness` 0) to smooth (1), or the harmonics from the mirrored direction r.
vec3 surroundings(vec3 n, vec3 r, float smoothness, float roughness) {
#if PROBE
  float level = smoothness * float(GLOSS_LEVELS - 1);
  float below = min(floor(level), float(GLOSS_LEVELS - 2));
  vec2 at = 0.5 + 0.5 * n.xy;
  return mix(texture(gloss_table, vec3(at, below)).rgb,
             texture(gloss_table, vec3(at, below + 1.0)).rgb, level - below);
#else
  return blurred(r, roughness);
#endif
}

// What the camera saw in direction r. Pinhole camera looking along +z; beyond its edges, and for
// rays that never meet its picture, the edge.
#if REFLECTION_MAP
vec3 in_camera(vec3 r) {
  vec2 tangent = r.xy / max(r.z, 1e-3);
  return texture(reflection_map, 0.5 + tangent * reflection_scale).rgb;
}
#endif

float schlick(float cosine) {
  float c = 1.0 - cosine;
  float c2 = c * c;
  return normal_reflectance + (1.0 - normal_reflectance) * c2 * c2 * c;
}

float fresnel(float cosine) {
  float n = refractive_index;
  float beyond = sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
  float s = (cosine - n * beyond) / (cosine + n * beyond);
  float p = (n * cosine - beyond) / (n * cosine + beyond);
  return 0.5 * (s * s + p * p);
}

// A lamp's mirror: the facets that send its light to the viewer.
struct Facets {
  vec3 normal;
  float per_v_h;  // 1 / v.h
  float F;        // Fresnel at v.h; 0 for a lamp straight behind the canvas
};

Facets facets_of(vec3 l) {
  vec3 halfway = l + vec3(0.0, 0.0, 1.0);
  float size = sqrt(dot(halfway, halfway));
  if (size < 1e-3) return Facets(vec3(0.0, 0.0, 1.0), 1.0, 0.0);
  return Facets(halfway / size, 2.0 / size, fresnel(0.5 * size));
}

// Torrance-Sparrow with Beckmann's facets and V-grooves, times n.l: what a lamp of irradiance 1
// sends to the viewer. `per_a2`: 1 / roughness^2.
float lobe(vec3 n, float n_l, Facets facets, float per_a2) {
  float n_v = n.z, n_h = max(dot(n, facets.normal), 1e-3);
  float per_c2 = 1.0 / (n_h * n_h);
  float density = exp((1.0 - per_c2) * per_a2) * (per_c2 * per_c2) * (per_a2 / kPi);
  float grooves = min(1.0, 2.0 * n_h * min(n_v, max(n_l, 0.0)) * facets.per_v_h);
  return facets.F * density * grooves / (4.0 * n_v);
}
