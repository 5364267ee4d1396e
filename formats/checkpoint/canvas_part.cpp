#include "formats/checkpoint/canvas_part.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pentimento::checkpoint {

namespace {
/// A canvas deeper than this, or paint faster, is no canvas: every cap of the model is far below.
constexpr float kMostOfAnything = 1e6f;

template <typename T>
void put_plane(const Field<T>& plane, ArchiveWriter& to) {
  for (int y = 0; y < plane.height(); ++y) {
    const std::span<const T> row = plane.view().row_span(y);
    const auto zero_bits = [](T v) {
      static constexpr T kZero{};
      return std::memcmp(&v, &kZero, sizeof(T)) == 0;  // -0 is not 0 here
    };
    const auto begin = std::find_if_not(row.begin(), row.end(), zero_bits);
    auto end = row.end();
    while (end != begin && zero_bits(*(end - 1))) --end;
    to.u32(static_cast<std::uint32_t>(begin - row.begin()));
    to.u32(static_cast<std::uint32_t>(end - begin));
    to.raw(row.subspan(static_cast<std::size_t>(begin - row.begin()),
                       static_cast<std::size_t>(end - begin)));
  }
}

template <typename T>
void take_plane(Field<T>& plane, ArchiveReader& from) {
  const auto width = static_cast<std::uint32_t>(plane.width());
  for (int y = 0; y < plane.height() && from.ok(); ++y) {
    const std::uint32_t begin = from.u32(), count = from.u32();
    if (begin > width || count > width - begin) return from.fail("a row is wider than the canvas");
    from.raw(std::span<T>(plane.row(y) + begin, count));
  }
}

bool in_range(std::span<const float> values, float least) {
  return std::ranges::all_of(values, [&](float v) { return v >= least && v <= kMostOfAnything; });
}

void check_range(const Field<float>& plane, float least, ArchiveReader& from) {
  for (int y = 0; y < plane.height(); ++y)
    if (!in_range(plane.view().row_span(y), least)) return from.fail("a value is out of its range");
}

/// The ground, and where the plane differs from it.
void put_ground(const GroundPlane& plane, ArchiveWriter& to) {
  to.f32(plane.ground());
  put_plane(plane.differences().bits(), to);
}

GroundPlane take_ground(const CanvasGeometry& grid, ArchiveReader& from) {
  const float ground = from.f32();
  DifferencePlane differences(grid.width, grid.height);
  take_plane(differences.bits(), from);
  GroundPlane plane(ground, std::move(differences));
  std::vector<float> row(static_cast<std::size_t>(grid.width));
  for (int y = 0; y < grid.height && from.ok(); ++y) {
    plane.read(0, y, row);
    if (!in_range(row, 0)) from.fail("a value is out of its range");
  }
  return plane;
}

/// The float planes in their order in the part; `sign` tells whether values may be below 0.
template <typename State, typename Body>
void for_planes(State& state, const Body& body) {
  body(state.depth_m, false);
  body(state.velocity_x_m_s, true);
  body(state.velocity_y_m_s, true);
  body(state.base_m, true);
  for (auto& plane : state.pigment) body(plane, false);
}
}  // namespace

void put_canvas(const CanvasState& state, ArchiveWriter& to) {
  to.i32(state.geometry.width);
  to.i32(state.geometry.height);
  to.i32(state.layers);
  to.i32(state.channels);
  to.i32(state.bands);
  to.i64(state.step);
  for_planes(state, [&](const Field<float>& plane, bool) { put_plane(plane, to); });
  for (const GroundPlane& plane : state.reflectance) put_ground(plane, to);
  put_plane(state.stroke, to);
  to.list(std::span<const float>(state.sleep));
}

CanvasState take_canvas(const GuideShape& shape, ArchiveReader& from) {
  CanvasState state;
  const bool same = from.i32() == shape.geometry.width && from.i32() == shape.geometry.height &&
                    from.i32() == shape.layers && from.i32() == shape.channels &&
                    from.i32() == shape.bands;
  if (!same) from.fail("it is of another canvas");
  if (!from.ok()) return state;
  state = make_canvas_state(shape.geometry, shape.layers, shape.channels, shape.bands, 0);
  state.step = from.i64();
  if (state.step < 0) from.fail("its step is below 0");
  for_planes(state, [&](Field<float>& plane, bool is_signed) {
    take_plane(plane, from);
    check_range(plane, is_signed ? -kMostOfAnything : 0, from);
  });
  for (GroundPlane& plane : state.reflectance) plane = take_ground(shape.geometry, from);
  take_plane(state.stroke, from);
  state.sleep = from.list<float>();
  return state;
}

}  // namespace pentimento::checkpoint
