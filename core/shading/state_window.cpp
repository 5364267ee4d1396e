#include "core/shading/state_window.h"

#include <algorithm>
#include <array>
#include <optional>

namespace pentimento {
namespace {

/// Rows of one plane under a window, the grid's edge repeated beyond it.
class WindowRows {
 public:
  WindowRows(const CanvasSource& canvas, const CellWindow& window)
      : canvas_(canvas),
        window_(window),
        last_x_(canvas.geometry().width - 1),
        last_y_(canvas.geometry().height - 1),
        begin_(std::clamp(window.x, 0, last_x_)),
        end_(std::clamp(window.x + window.width - 1, 0, last_x_) + 1) {}

  /// Row `j` of the window.
  void read(PlaneId plane, int j, std::vector<float>& out) const {
    out.resize(static_cast<std::size_t>(window_.width));
    const int y = std::clamp(window_.y + j, 0, last_y_);
    // Where a window lies beyond the grid, its one column of cells is read into the first value.
    const int before = std::clamp(begin_ - window_.x, 0, window_.width - 1);
    const int inside = std::min(end_ - begin_, window_.width - before);
    float* first = out.data() + before;
    canvas_.read(plane, begin_, y, {first, static_cast<std::size_t>(inside)});
    std::fill(out.data(), first, *first);
    std::fill(first + inside, out.data() + out.size(), first[inside - 1]);
  }

  /// The part of the window that lies on the grid; its edge where none does.
  CellWindow on_grid() const {
    const int top = std::clamp(window_.y, 0, last_y_);
    const int bottom = std::clamp(window_.y + window_.height - 1, 0, last_y_);
    return {begin_, top, end_ - begin_, bottom + 1 - top};
  }

 private:
  const CanvasSource& canvas_;
  CellWindow window_;
  int last_x_, last_y_;
  int begin_, end_;  // columns that are read
};

std::size_t cells(const CellWindow& window) {
  return static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
}

/// Four planes, value by value; nothing stands for a plane of zeros.
void interleave(const CanvasSource& canvas, const std::array<std::optional<PlaneId>, 4>& planes,
                const CellWindow& window, std::vector<float>& texels) {
  const WindowRows rows(canvas, window);
  texels.resize(4 * cells(window));
  std::array<std::vector<float>, 4> row;
  for (std::vector<float>& r : row) r.assign(static_cast<std::size_t>(window.width), 0.0f);
  float* out = texels.data();
  for (int j = 0; j < window.height; ++j) {
    for (std::size_t p = 0; p < 4; ++p) {
      if (planes[p]) rows.read(*planes[p], j, row[p]);
    }
    const float *a = row[0].data(), *b = row[1].data(), *c = row[2].data(), *d = row[3].data();
    for (int i = 0; i < window.width; ++i, out += 4) {
      out[0] = a[i];
      out[1] = b[i];
      out[2] = c[i];
      out[3] = d[i];
    }
  }
}

}  // namespace

void pack_ground(const CanvasSource& canvas, const CellWindow& window, std::vector<float>& texels) {
  interleave(canvas,
             {reflectance_plane(0), reflectance_plane(1), reflectance_plane(2),
              PlaneId{PlaneKind::kDepth}},
             window, texels);
}

void pack_bands(const CanvasSource& canvas, int texel, const CellWindow& window,
                std::vector<float>& texels) {
  std::array<std::optional<PlaneId>, 4> planes{};
  for (int b = 0; b < 4 && 4 * texel + b < canvas.bands(); ++b) {
    planes[static_cast<std::size_t>(b)] = reflectance_plane(4 * texel + b);
  }
  interleave(canvas, planes, window, texels);
}

void pack_relief(const CanvasSource& canvas, const CellWindow& window, std::vector<float>& texels) {
  const WindowRows rows(canvas, window);
  texels.resize(2 * cells(window));
  std::vector<float> base, depth, paper;
  float* out = texels.data();
  for (int j = 0; j < window.height; ++j) {
    rows.read({PlaneKind::kBase}, j, base);
    rows.read({PlaneKind::kDepth}, j, depth);
    rows.read({PlaneKind::kPaper}, j, paper);
    for (std::size_t i = 0; i < base.size(); ++i, out += 2) {
      out[0] = base[i] + depth[i];
      out[1] = out[0] - paper[i];
    }
  }
}

void pack_amounts(const CanvasSource& canvas, int layer, int plane, const CellWindow& window,
                  std::vector<float>& texels) {
  if (canvas.empty(WindowRows(canvas, window).on_grid())) {
    texels.assign(4 * cells(window), 0.0f);
    return;
  }
  std::array<std::optional<PlaneId>, 4> planes{};
  for (int c = 0; c < 4 && 4 * plane + c < canvas.channels(); ++c) {
    planes[static_cast<std::size_t>(c)] = pigment_plane(layer, 4 * plane + c);
  }
  interleave(canvas, planes, window, texels);
}

}  // namespace pentimento
