#pragma once
// A state dump with a different value everywhere.

#include <random>

#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "formats/hdf5/state_dump.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento::test {

inline void fill(Field<float>& plane, std::mt19937& random, float scale) {
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x)
      plane(x, y) = scale * static_cast<float>(random() % 1024) / 1023.0f;
}

inline std::vector<Pigment> made_up_palette(int pigments) {
  std::vector<Pigment> palette;
  for (int i = 0; i < pigments; ++i) {
    Pigment p;
    p.name = "pigment " + std::to_string(i);
    p.K = Eigen::Vector3d(0.1 * i, 0.2, 1.0 / (i + 3));
    p.S = Eigen::Vector3d(0.7, 0.03 * i, 0.5);
    palette.push_back(p);
  }
  return palette;
}

inline Lighting made_up_lighting() {
  Lighting light;
  light.lamps[0].intensity = 1.7f;
  light.lamps[0].color = {1.0f, 0.9f, 0.8f};
  light.lamps[0].follows_gravity = true;
  for (std::size_t i = 0; i < 9; ++i)
    light.environment.L[i] = {0.1f * static_cast<float>(i), 0.3f, -0.02f};
  light.lamps[0].position_m = {0.1f, -0.2f, 0.9f};
  Lamp second;
  second.direction = {0, 0.6f, 0.8f};
  second.intensity = 0.3f;
  light.lamps.push_back(second);
  Lamp third;  // near, and not turned with the canvas
  third.position_m = {-0.3f, 0.1f, 0.7f};
  third.follows_gravity = false;
  light.lamps.push_back(third);
  light.varnish = 0.25f;
  light.occlusion = 0.5f;
  light.white_xy = {0.35f, 0.36f};
  light.tone = ToneCurve::kFilmic;
  light.reflection.fov_deg = 71;
  light.reflection.mirror = false;
  std::mt19937 random(5);
  for (Field<float>& plane : light.reflection.rgb) {
    plane = Field<float>(13, 7);
    fill(plane, random, 2.0f);
  }
  for (Field<float>& plane : light.probe) {
    plane = Field<float>(12, 6);
    fill(plane, random, 3.0f);
  }
  light.roughness_wet = 0.21f;
  light.exposure_ev = -0.5f;
  return light;
}

inline StateDump made_up_dump(int width, int height, int layers, int pigments) {
  StateDump dump;
  dump.palette = made_up_palette(pigments);
  if (pigments > 0) dump.basis = make_channels(dump.palette);
  if (pigments == 0) {
    dump.basis.K.resize(3, 0);
    dump.basis.S.resize(3, 0);
    dump.basis.load.resize(0, 0);
  }
  CanvasGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  geometry.width_m = 0.6;
  geometry.height_m = 0.45;
  dump.state = make_canvas_state(geometry, layers, dump.basis.channels(), 3, 0.9f);
  std::mt19937 random(1);
  CanvasState& s = dump.state;
  fill(s.depth_m, random, 0.002f);
  fill(s.velocity_x_m_s, random, 0.1f);
  fill(s.velocity_y_m_s, random, -0.1f);
  Field<float> paper_m(width, height), band(width, height);
  fill(paper_m, random, 0.0003f);
  fill(s.base_m, random, 0.001f);
  for (int y = 0; y < height; ++y) write_paper(s, 0, y, paper_m.view().row_span(y));
  for (GroundPlane& plane : s.reflectance) {
    fill(band, random, 1.0f);
    for (int y = 0; y < height; ++y) plane.write(0, y, band.view().row_span(y));
  }
  for (Field<float>& plane : s.pigment) fill(plane, random, 0.1f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) s.stroke(x, y) = random() % 5 == 0 ? 4000000000u : random() % 9;
  s.step = 5692;
  dump.time_s = 126.5;
  dump.model.nu_max_m2_s = 0.02f;
  dump.model.scheme = SchemeKind::kConservative;
  const conservative::SleepTiles tiles(geometry, dump.model.sleep_tile_m);
  for (int i = 0; i < tiles.count() * conservative::kSleepValues; ++i)
    s.sleep.push_back(static_cast<float>(random() % 1024) / 1023.0f);
  dump.lighting = made_up_lighting();
  dump.log_sha256 = std::string(64, 'a');
  return dump;
}

/// A guide of 61 x 47 cells under a canvas k times finer.
inline StateDump made_up_detail_dump(int k, int layers = 2, int pigments = 3) {
  StateDump dump = made_up_dump(61, 47, layers, pigments);
  dump.detail = k;
  CanvasGeometry fine = dump.state.geometry;
  fine.width *= k;
  fine.height *= k;
  dump.fine = std::make_shared<reference::MadeUpCanvas>(fine, layers, dump.state.channels);
  return dump;
}

}  // namespace pentimento::test
