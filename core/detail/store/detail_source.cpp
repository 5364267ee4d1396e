#include "core/detail/store/detail_source.h"

#include <algorithm>

namespace pentimento {

namespace {
std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// The tile's own values of a plane, or nullptr if it has none.
const float* plane_of(const DetailTile& tile, PlaneId plane, int channels) {
  switch (plane.kind) {
    case PlaneKind::kDepth:
      return tile.depth_m.data();
    case PlaneKind::kBase:
      return tile.base_m.data();
    case PlaneKind::kPigment:
      return tile.pigment[index(plane.layer * channels + plane.index)].data();
    case PlaneKind::kReflectance:
      return tile.reflectance.empty() ? nullptr : tile.reflectance[index(plane.index)].data();
    default:
      return nullptr;
  }
}

void read_substrate(const DetailSubstrate& substrate, PlaneId plane, int x, int y,
                    std::span<float> out) {
  if (plane.kind == PlaneKind::kBase || plane.kind == PlaneKind::kPaper) {
    substrate.relief_row(x, y, out);
  } else if (plane.kind == PlaneKind::kReflectance) {
    substrate.reflectance_row(plane.index, x, y, out);
  } else {
    std::fill(out.begin(), out.end(), 0.0f);
  }
}

/// Where a fine position lies between the samples of the guide's plane.
struct Between {
  int low;  // may be -1
  float share;
};
Between between_faces(int fine, int factor) {
  const int low = (fine + 1) / factor - 1;
  return {low, static_cast<float>((fine + 1) % factor) / static_cast<float>(factor)};
}
Between between_centres(int fine, int factor) {
  const float position = (static_cast<float>(fine) + 0.5f) / static_cast<float>(factor) - 0.5f;
  const int low = position < 0 ? -1 : static_cast<int>(position);
  return {low, position - static_cast<float>(low)};
}

/// Bilinear interpolation. Faces before the first are walls; beyond the outermost centres their
/// values repeat.
float interpolated(const Field<float>& plane, Between x, Between y, bool walls_in_x) {
  const auto value = [&](int i, int j) {
    if ((walls_in_x ? i : j) < 0) return 0.0f;
    return plane(std::clamp(i, 0, plane.width() - 1), std::clamp(j, 0, plane.height() - 1));
  };
  const float top = value(x.low, y.low) + x.share * (value(x.low + 1, y.low) - value(x.low, y.low));
  const float bottom =
      value(x.low, y.low + 1) + x.share * (value(x.low + 1, y.low + 1) - value(x.low, y.low + 1));
  return top + y.share * (bottom - top);
}

/// Whether nothing moves in the rows `low` and `low` + 1.
bool rests(const Field<float>& plane, int low) {
  const auto zero = [](float v) { return v == 0; };
  for (int y = std::max(low, 0); y <= std::min(low + 1, plane.height() - 1); ++y)
    if (!std::all_of(plane.row(y), plane.row(y) + plane.width(), zero)) return false;
  return true;
}

/// Whether the guide moves in the cells that velocities in the window are interpolated from.
bool flows(const CanvasState& guide, int factor, const CellWindow& window) {
  const int x0 = std::max(0, window.x / factor - 1), y0 = std::max(0, window.y / factor - 1);
  const int x1 = std::min(guide.geometry.width, (window.x + window.width) / factor + 2);
  const int y1 = std::min(guide.geometry.height, (window.y + window.height) / factor + 2);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      if (guide.velocity_x_m_s(x, y) != 0 || guide.velocity_y_m_s(x, y) != 0) return true;
  return false;
}
}  // namespace

DetailSource::DetailSource(const DetailCanvas& canvas, const CanvasState& guide)
    : canvas_(canvas), guide_(guide), geometry_(canvas.layout().fine()) {}

void DetailSource::read(PlaneId plane, int x, int y, std::span<float> out) const {
  if (plane.kind == PlaneKind::kVelocityX || plane.kind == PlaneKind::kVelocityY) {
    read_velocity(plane.kind, x, y, out);
  } else if (plane.kind == PlaneKind::kPaper) {
    canvas_.substrate().relief_row(x, y, out);
  } else {
    read_tiles(plane, x, y, out);
  }
}

/// Only a store that gives tiles back is trimmed, so only there do readers and the one that trims
/// wait for one another.
std::shared_lock<std::shared_mutex> DetailSource::begin_reading() const {
  if (!canvas_.gives_back()) return {};
  release();
  return std::shared_lock<std::shared_mutex>(mutex_);
}

void DetailSource::release() const {
  constexpr std::uint32_t kReadsBetweenTrims = 8192;
  if (++reads_ % kReadsBetweenTrims != 0) return;
  const std::unique_lock<std::shared_mutex> alone(mutex_);
  canvas_.trim();
}

void DetailSource::read_tiles(PlaneId plane, int x, int y, std::span<float> out) const {
  const std::shared_lock<std::shared_mutex> together = begin_reading();
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.side();
  for (int done = 0; done < static_cast<int>(out.size());) {
    const int from = x + done;
    const int cells = std::min(side - from % side, static_cast<int>(out.size()) - done);
    const DetailTile* tile = canvas_.find(layout.tile_of(from / side, y / side));
    if (tile != nullptr) canvas_.mark_used(tile->tile);
    const float* data = tile == nullptr ? nullptr : plane_of(*tile, plane, channels());
    const std::span<float> part = out.subspan(index(done), index(cells));
    if (data == nullptr) {
      read_substrate(canvas_.substrate(), plane, from, y, part);
    } else {
      std::copy_n(data + static_cast<std::ptrdiff_t>(y % side) * side + from % side, cells,
                  part.data());
    }
    done += cells;
  }
}

void DetailSource::read_velocity(PlaneKind kind, int x, int y, std::span<float> out) const {
  const int k = canvas_.layout().factor();
  const bool along_x = kind == PlaneKind::kVelocityX;
  const Field<float>& plane = along_x ? guide_.velocity_x_m_s : guide_.velocity_y_m_s;
  const Between row = along_x ? between_centres(y, k) : between_faces(y, k);
  if (rests(plane, row.low)) {
    std::fill(out.begin(), out.end(), 0.0f);
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int fine = x + static_cast<int>(i);
    out[i] = interpolated(plane, along_x ? between_faces(fine, k) : between_centres(fine, k), row,
                          along_x);
  }
}

void DetailSource::read_strokes(int x, int y, std::span<std::uint32_t> out) const {
  const int k = canvas_.layout().factor();
  const std::uint32_t* row = guide_.stroke.row(y / k);
  const int cells = static_cast<int>(out.size());
  for (int i = 0; i < cells;) {
    const int block = (x + i) / k, end = std::min(cells, (block + 1) * k - x);
    std::fill(out.begin() + i, out.begin() + end, row[block]);
    i = end;
  }
}

bool DetailSource::empty(const CellWindow& window) const {
  const DetailLayout& layout = canvas_.layout();
  if (flows(guide_, layout.factor(), window)) return false;
  const int side = layout.side();
  for (int row = window.y / side; row * side < window.y + window.height; ++row) {
    for (int column = window.x / side; column * side < window.x + window.width; ++column) {
      const DetailTile* tile = canvas_.find(layout.tile_of(column, row));
      if (tile == nullptr) continue;
      if (tile->depth_m) return false;
      for (const TilePlane& plane : tile->pigment)
        if (plane) return false;
    }
  }
  return true;
}

}  // namespace pentimento
