// The state at a sample: which cells it lies between (tables, so that every tile computes with the
// same numbers), bilinear colours, and the relief by cubic interpolation (A38).
#if INTERPOLATE
uniform sampler2D columns;        // per sample column: cell left of it, fraction of the way right
uniform sampler2D rows;           // per sample row: cell above it, fraction of the way down
#endif
uniform sampler2D ground;         // colour of all paint, depth of wet paint (m)
#if SLOPES_READY
uniform sampler2D slopes;         // height (m), thickness of all paint (m), slopes as in Relief
#else
uniform sampler2D relief;         // height (m), thickness of all paint, dry and wet (m)
#endif
#ifdef PIGMENT_TARGET
uniform sampler2DArray amounts;   // four channels a texel, of all layers together
#endif
uniform vec2 relief_per_cell;     // relief scale / cell size (1/m)
uniform int relief_border;        // cells of the relief's window around that of the others

struct Place {
  ivec2 cell;
  vec2 fraction;
};

#if INTERPOLATE
Place place_at(ivec2 sample_index) {
  vec2 column = texelFetch(columns, ivec2(sample_index.x, 0), 0).rg;
  vec2 row = texelFetch(rows, ivec2(sample_index.y, 0), 0).rg;
  return Place(ivec2(int(column.r), int(row.r)), vec2(column.g, row.g));
}
#else
Place place_at(ivec2 sample_index) { return Place(sample_index + CELLS_BEFORE, vec2(0.0)); }
#endif

#if SLOPES_READY
vec2 relief_of(ivec2 cell) { return texelFetch(slopes, cell, 0).rg; }
#else
vec2 relief_of(ivec2 cell) { return texelFetch(relief, cell + relief_border, 0).rg; }
#endif

#if INTERPOLATE
vec4 between(vec4 a, vec4 b, vec4 c, vec4 d, vec2 f) {
  vec4 upper = a * (1.0 - f.x) + b * f.x;
  vec4 lower = c * (1.0 - f.x) + d * f.x;
  return upper * (1.0 - f.y) + lower * f.y;
}
vec4 read(sampler2D plane, Place p) {
  return between(texelFetch(plane, p.cell, 0), texelFetch(plane, p.cell + ivec2(1, 0), 0),
                 texelFetch(plane, p.cell + ivec2(0, 1), 0),
                 texelFetch(plane, p.cell + ivec2(1, 1), 0), p.fraction);
}
vec4 read_layer(sampler2DArray stack, int layer, Place p) {
  ivec3 at = ivec3(p.cell, layer);
  return between(texelFetch(stack, at, 0), texelFetch(stack, at + ivec3(1, 0, 0), 0),
                 texelFetch(stack, at + ivec3(0, 1, 0), 0),
                 texelFetch(stack, at + ivec3(1, 1, 0), 0), p.fraction);
}
float paint_m(Place p) {
  return between(vec4(relief_of(p.cell).g), vec4(relief_of(p.cell + ivec2(1, 0)).g),
                 vec4(relief_of(p.cell + ivec2(0, 1)).g), vec4(relief_of(p.cell + ivec2(1, 1)).g),
                 p.fraction)
      .r;
}
#else
float paint_m(Place p) { return relief_of(p.cell).g; }
vec4 read(sampler2D plane, Place p) { return texelFetch(plane, p.cell, 0); }
vec4 read_layer(sampler2DArray stack, int layer, Place p) {
  return texelFetch(stack, ivec3(p.cell, layer), 0);
}
#endif

struct Relief {
  float height;
  vec2 slope;  // dh/dx to the right, dh/dy down; per metre, times the relief scale
};

float height_at(Place p, int x, int y) { return relief_of(p.cell + ivec2(x, y)).r; }

// Catmull-Rom weights of cells -1, 0, 1, 2 and their derivatives: at a cell they are the value and
// the central difference.
vec4 cubic(float t) {
  return vec4(((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0,
              ((-1.5 * t + 2.0) * t + 0.5) * t, (0.5 * t - 0.5) * t * t);
}
vec4 cubic_slope(float t) {
  return vec4((-1.5 * t + 2.0) * t - 0.5, (4.5 * t - 5.0) * t, (-4.5 * t + 4.0) * t + 0.5,
              (1.5 * t - 1.0) * t);
}

#if INTERPOLATE
Relief relief_at(Place p) {
  vec4 across = cubic(p.fraction.x), across_slope = cubic_slope(p.fraction.x);
  vec4 down = cubic(p.fraction.y), down_slope = cubic_slope(p.fraction.y);
  Relief r = Relief(0.0, vec2(0.0));
  for (int j = 0; j < 4; ++j) {
    vec4 h = vec4(height_at(p, -1, j - 1), height_at(p, 0, j - 1), height_at(p, 1, j - 1),
                  height_at(p, 2, j - 1));
    float value = dot(across, h);
    r.height += down[j] * value;
    r.slope += vec2(down[j] * dot(across_slope, h), down_slope[j] * value);
  }
  r.slope *= relief_per_cell;
  return r;
}
#elif SLOPES_READY
Relief relief_at(Place p) {
  vec4 cell = texelFetch(slopes, p.cell, 0);
  return Relief(cell.r, cell.ba);
}
#else
Relief relief_at(Place p) {
  vec2 slope = 0.5 * vec2(height_at(p, 1, 0) - height_at(p, -1, 0),
                          height_at(p, 0, 1) - height_at(p, 0, -1));
  return Relief(height_at(p, 0, 0), slope * relief_per_cell);
}
#endif

#if RELIEF_SAMPLES > 1
// Slopes of the relief at the centres of the cell's quarters, by cubic interpolation.
void slopes_in_cell(Place p, out vec2 slopes[4]) {
  vec4 value = cubic(0.25), slope = cubic_slope(0.25);
  for (int i = 0; i < 4; ++i) slopes[i] = vec2(0.0);
  for (int j = -2; j <= 2; ++j) {
    float far_left = height_at(p, -2, j), left = height_at(p, -1, j), here = height_at(p, 0, j);
    float right = height_at(p, 1, j), far_right = height_at(p, 2, j);
    vec4 before = vec4(right, here, left, far_left);  // mirrored: a quarter to the left
    vec4 after = vec4(left, here, right, far_right);
    vec2 height = vec2(dot(value, before), dot(value, after));
    vec2 rise = vec2(-dot(slope, before), dot(slope, after));
    if (j < 2) {  // a quarter up, mirrored too
      slopes[0] += vec2(value[1 - j] * rise.x, -slope[1 - j] * height.x);
      slopes[1] += vec2(value[1 - j] * rise.y, -slope[1 - j] * height.y);
    }
    if (j > -2) {  // a quarter down
      slopes[2] += vec2(value[j + 1] * rise.x, slope[j + 1] * height.x);
      slopes[3] += vec2(value[j + 1] * rise.y, slope[j + 1] * height.y);
    }
  }
  for (int i = 0; i < 4; ++i) slopes[i] *= relief_per_cell;
}
#endif

// In the viewer's frame (y up), while slopes run down the rows.
vec3 normal_of(vec2 slope) { return normalize(vec3(-slope.x, slope.y, 1.0)); }
