#include "core/canvas/canvas_source.h"

#include <gtest/gtest.h>

#include <array>

namespace pentimento {
namespace {

TEST(StateSource, ReadsRunsOfEveryPlane) {
  CanvasState s = make_canvas_state({5, 3, 1, 1}, 2, 2, 3, 0);
  s.step = 9;
  s.depth_m(3, 2) = 1;
  s.velocity_x_m_s(3, 2) = 2;
  s.velocity_y_m_s(3, 2) = 3;
  s.base_m(3, 2) = 4;
  s.paper.set(3, 2, 4, 5);
  s.reflectance[1].set(3, 2, 6);
  s.channel(1, 0)(3, 2) = 7;
  s.stroke(3, 2) = 8;
  const StateSource source(s);
  EXPECT_EQ(source.step(), 9);
  EXPECT_EQ(source.layers() * 100 + source.channels() * 10 + source.bands(), 223);
  const std::pair<PlaneId, float> planes[] = {
      {{PlaneKind::kDepth}, 1},  {{PlaneKind::kVelocityX}, 2}, {{PlaneKind::kVelocityY}, 3},
      {{PlaneKind::kBase}, 4},   {{PlaneKind::kPaper}, 5},     {reflectance_plane(1), 6},
      {reflectance_plane(2), 0}, {pigment_plane(1, 0), 7},     {pigment_plane(0, 1), 0}};
  for (const auto& [plane, value] : planes) {
    std::array<float, 3> run = {-1, -1, -1};
    source.read(plane, 2, 2, run);
    EXPECT_EQ(run, (std::array<float, 3>{0, value, 0}));
  }
  std::array<std::uint32_t, 2> strokes{};
  source.read_strokes(3, 2, strokes);
  EXPECT_EQ(strokes, (std::array<std::uint32_t, 2>{8, 0}));
}

}  // namespace
}  // namespace pentimento
