// Lamps as a point of the canvas sees them. Viewer's frame, metres from the canvas's centre.
#if LAMPS > 0
uniform vec3 lamp_place[LAMPS];     // direction towards it; of a near one its position (m)
uniform float lamp_range2[LAMPS];   // near: squared distance from the centre (m^2); 0 = far away
uniform vec3 lamp_radiance[LAMPS];  // irradiance at normal incidence / pi; near: at the centre
uniform vec3 lamp_facets[LAMPS];    // of a far one: normal of the facets that mirror it,
uniform vec2 lamp_mirror[LAMPS];    // 1 / v.h and Fresnel's share there
#endif
uniform vec2 first_cell;  // of the tile's window, in the grid
uniform vec2 cell_m;
uniform vec2 half_canvas_m;

struct Lit {
  vec3 direction;
  vec3 radiance;
};

// `cell`: in the window, with its fraction. Whole numbers below 2^24 are exact, so the sum is that
// of every other tile.
vec3 point_at(ivec2 cell, vec2 fraction, float height_m) {
  vec2 at = ((first_cell + vec2(cell)) + fraction + 0.5) * cell_m - half_canvas_m;
  return vec3(at.x, -at.y, height_m);
}

#if LAMPS > 0
Lit lamp_at(int i, vec3 point) {
  if (lamp_range2[i] == 0.0) return Lit(lamp_place[i], lamp_radiance[i]);
  vec3 to = lamp_place[i] - point;
  float range2 = max(dot(to, to), 1e-8);
  return Lit(to / sqrt(range2), lamp_radiance[i] * (lamp_range2[i] / range2));
}
#endif
