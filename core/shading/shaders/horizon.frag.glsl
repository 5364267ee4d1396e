// What the relief leaves of the sky and of each lamp, per cell, by a search for the horizon along
// lines of cells. One value a channel: the sky's first, then the lamps' in their order.
//   sky:  mean over directions of cos^2 of the horizon's height above the tangent plane
//   lamp: how far it stands above the horizon on its side, over its own size
// Source: Bavoil, Sainz and Dimitrov 2008 (horizons of a height field, with the tangent plane).
// Departs from it: lines of whole cells at growing distances, the same for every cell, so that
// nothing is random and no tile differs.
uniform sampler2D relief;  // height (m) in its first channel
uniform int relief_border;    // cells of the relief's window around ours
uniform float relief_scale;
uniform vec3 sky_step[SKY_DIRECTIONS * MOST_STEPS];  // cells right, cells down, 1 / distance (1/m)
uniform float shadow_step[MOST_STEPS];               // cells along the longer axis
// Counts that the compiler does not know: unrolled, the search takes seconds to compile.
uniform int sky_directions, sky_steps, shadow_steps;

layout(location = 0) out vec4 seen_first;
#if OCCLUSION_PLANES > 1
layout(location = 1) out vec4 seen_second;
#endif

const float kLampSize = 0.12;  // tangent of half the angle that a lamp takes: a soft box

float height_of(ivec2 cell) { return texelFetch(relief, cell + relief_border, 0).r; }

// Rise per metre, right and down.
vec2 slope_of(ivec2 c) {
  return 0.5 * relief_scale / cell_m *
         vec2(height_of(c + ivec2(1, 0)) - height_of(c - ivec2(1, 0)),
              height_of(c + ivec2(0, 1)) - height_of(c - ivec2(0, 1)));
}

float sky_seen(ivec2 cell, float height) {
  vec2 slope = slope_of(cell);
  float seen = 0.0;
  for (int d = 0; d < sky_directions; ++d) {
    float rise = 0.0;
    for (int i = 0; i < sky_steps; ++i) {
      vec3 to = sky_step[d * sky_steps + i];
      float plane = dot(slope, to.xy * cell_m);
      float above = (height_of(cell + ivec2(to.xy)) - height) * relief_scale - plane;
      rise = max(rise, above * to.z);
    }
    seen += 1.0 / (1.0 + rise * rise);
  }
  return seen / float(sky_directions);
}

#if LAMPS > 0
float lamp_seen(ivec2 cell, float height, vec3 direction) {
  vec2 along = vec2(direction.x, -direction.y) / cell_m;  // cells per metre, rows down
  float longer = max(abs(along.x), abs(along.y));
  float level = sqrt(dot(direction.xy, direction.xy));
  if (direction.z <= 0.0 || level < 1e-3 * direction.z) return 1.0;
  bool across = abs(along.x) >= abs(along.y);
  along = across ? vec2(sign(along.x), along.y / longer) : vec2(along.x / longer, sign(along.y));
  float cell_length = length(along * cell_m);
  float rise = 0.0;
  for (int i = 0; i < shadow_steps; ++i) {
    vec2 at = along * shadow_step[i];
    vec2 before = floor(at);
    float share = across ? at.y - before.y : at.x - before.x;
    ivec2 near = cell + ivec2(before);
    float h = mix(height_of(near), height_of(near + (across ? ivec2(0, 1) : ivec2(1, 0))), share);
    rise = max(rise, (h - height) * relief_scale / (shadow_step[i] * cell_length));
  }
  return clamp(0.5 + 0.5 * (direction.z / level - rise) / kLampSize, 0.0, 1.0);
}
#endif

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  float height = height_of(cell);
  float seen[4 * OCCLUSION_PLANES];
  for (int i = 0; i < 4 * OCCLUSION_PLANES; ++i) seen[i] = 1.0;
  seen[0] = sky_seen(cell, height);
#if LAMPS > 0
  for (int i = 0; i < LAMPS; ++i) {
    seen[i + 1] = lamp_seen(cell, height, lamp_at(i, point_at(cell, vec2(0.0), height)).direction);
  }
#endif
  seen_first = vec4(seen[0], seen[1], seen[2], seen[3]);
#if OCCLUSION_PLANES > 1
  seen_second = vec4(seen[4], seen[5], seen[6], seen[7]);
#endif
}
