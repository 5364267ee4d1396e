#include "core/canvas/canvas_source.h"

#include <algorithm>

namespace pentimento {

Field<float>& plane_of(CanvasState& state, PlaneId plane) {
  switch (plane.kind) {
    case PlaneKind::kDepth:
      return state.depth_m;
    case PlaneKind::kVelocityX:
      return state.velocity_x_m_s;
    case PlaneKind::kVelocityY:
      return state.velocity_y_m_s;
    case PlaneKind::kBase:
      return state.base_m;
    case PlaneKind::kPaper:
    case PlaneKind::kReflectance:
    case PlaneKind::kPigment:
      break;
  }
  PENTIMENTO_CHECK(plane.kind == PlaneKind::kPigment);
  return state.channel(plane.layer, plane.index);
}

const Field<float>& plane_of(const CanvasState& state, PlaneId plane) {
  return plane_of(const_cast<CanvasState&>(state), plane);  // which changes nothing
}

void StateSource::read(PlaneId plane, int x, int y, std::span<float> out) const {
  if (plane.kind == PlaneKind::kPaper) return read_paper(state_, x, y, out);
  if (plane.kind == PlaneKind::kReflectance)
    return state_.reflectance[static_cast<std::size_t>(plane.index)].read(x, y, out);
  std::copy_n(plane_of(state_, plane).row(y) + x, out.size(), out.data());
}

void StateSource::read_strokes(int x, int y, std::span<std::uint32_t> out) const {
  std::copy_n(state_.stroke.row(y) + x, out.size(), out.data());
}

}  // namespace pentimento
