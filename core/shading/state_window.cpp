#include "core/shading/state_window.h"

#include <algorithm>
#include <array>
#include <span>

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

/// Rows that one thread packs with the same buffers.
constexpr int kGrain = 8;

/// The planes from which the colour of a row follows.
class ColourRows {
 public:
  ColourRows(const CanvasSource& canvas, const CellWindow& window, bool has_paint)
      : rows_(canvas, window) {
    for (int b = 0; b < canvas.bands(); ++b) planes_.push_back(reflectance_plane(b));
    bands_ = planes_.size();
    for (int k = 0; has_paint && k < canvas.layers(); ++k) {
      for (int c = 0; c < canvas.channels(); ++c) planes_.push_back(pigment_plane(k, c));
    }
    values_.resize(planes_.size());
  }

  /// All but the depth, one plane of many.
  std::span<const PlaneId> planes() const { return planes_; }

  AlbedoCells read(int j) {
    rows_.read({PlaneKind::kDepth}, j, depth_);
    AlbedoCells out;
    out.depth_m = depth_;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      rows_.read(planes_[p], j, values_[p]);
      (p < bands_ ? out.dry : out.amount).push_back(values_[p].data());
    }
    return out;
  }

 private:
  WindowRows rows_;
  std::vector<PlaneId> planes_;
  std::size_t bands_ = 0;
  std::vector<float> depth_;
  std::vector<std::vector<float>> values_;
};

/// What wet paint covers of the cells of a window. A cell beyond the grid is covered as the cell
/// that it repeats, whose neighbours are others.
class WindowCoverage {
 public:
  WindowCoverage(const CanvasSource& canvas, const CellWindow& window)
      : window_(window),
        grid_(WindowRows(canvas, window).on_grid()),
        rows_(canvas, {grid_.x - kCoverageReach, grid_.y - kCoverageReach,
                       grid_.width + 2 * kCoverageReach, grid_.height + 2 * kCoverageReach}),
        on_grid_(static_cast<std::size_t>(grid_.width)),
        coverage_(static_cast<std::size_t>(window.width)) {}

  /// Of row `j` of the window.
  std::span<const float> read(int j) {
    read_depth(std::clamp(window_.y + j - grid_.y, 0, grid_.height - 1));
    edge_coverage_row(depth_, on_grid_);
    for (int i = 0; i < window_.width; ++i) {
      const int column = std::clamp(window_.x + i - grid_.x, 0, grid_.width - 1);
      coverage_[static_cast<std::size_t>(i)] = on_grid_[static_cast<std::size_t>(column)];
    }
    return coverage_;
  }

 private:
  /// Around row `j` of the grid's part. Rows that the last call read are not read again.
  void read_depth(int j) {
    for (int n = 0; n < static_cast<int>(depth_.size()); ++n) {
      std::vector<float>& row = depth_[static_cast<std::size_t>(n)];
      if (j == last_ + 1 && n + 1 < static_cast<int>(depth_.size()))
        row.swap(depth_[static_cast<std::size_t>(n + 1)]);
      else
        rows_.read({PlaneKind::kDepth}, j + n, row);
    }
    last_ = j;
  }

  CellWindow window_, grid_;
  WindowRows rows_;
  CoverageRows depth_;
  int last_ = -2;  // no row is after it
  std::vector<float> on_grid_, coverage_;
};

}  // namespace

void pack_albedo(const CanvasSource& canvas, const AlbedoOptics& optics, EdgeCells edges,
                 const CellWindow& window, const Threads& threads, std::vector<float>& texels) {
  texels.resize(4 * cells(window));
  const CellWindow on_grid = WindowRows(canvas, window).on_grid();
  const bool has_paint = !canvas.empty(on_grid);
  const auto row = 4 * static_cast<std::size_t>(window.width);
  canvas.expect(on_grid, ColourRows(canvas, window, has_paint).planes(), threads);
  threads.for_ranges(0, window.height, kGrain, [&](int begin, int end) {
    ColourRows rows(canvas, window, has_paint);
    WindowCoverage coverage(canvas, window);
    for (int j = begin; j < end; ++j) {
      AlbedoCells cells = rows.read(j);
      if (has_paint && edges == EdgeCells::kPartlyCovered) cells.coverage = coverage.read(j);
      albedo_row(optics, cells, {texels.data() + row * static_cast<std::size_t>(j), row});
    }
  });
}

void pack_relief(const CanvasSource& canvas, const CellWindow& window, const Threads& threads,
                 std::vector<float>& texels) {
  const WindowRows rows(canvas, window);
  texels.resize(2 * cells(window));
  constexpr std::array<PlaneId, 3> kPlanes = {
      {{PlaneKind::kBase}, {PlaneKind::kDepth}, {PlaneKind::kPaper}}};
  canvas.expect(rows.on_grid(), kPlanes, threads);
  threads.for_ranges(0, window.height, kGrain, [&](int begin, int end) {
    std::vector<float> base, depth, paper;
    float* out = texels.data() +
                 2 * static_cast<std::size_t>(window.width) * static_cast<std::size_t>(begin);
    for (int j = begin; j < end; ++j) {
      rows.read({PlaneKind::kBase}, j, base);
      rows.read({PlaneKind::kDepth}, j, depth);
      rows.read({PlaneKind::kPaper}, j, paper);
      for (std::size_t i = 0; i < base.size(); ++i, out += 2) {
        out[0] = base[i] + depth[i];
        out[1] = out[0] - paper[i];
      }
    }
  });
}

void pack_amounts(const CanvasSource& canvas, int plane, const CellWindow& window,
                  const Threads& threads, std::vector<float>& texels) {
  texels.assign(4 * cells(window), 0.0f);
  if (canvas.empty(WindowRows(canvas, window).on_grid())) return;
  const WindowRows rows(canvas, window);
  const int channels = std::min(canvas.channels() - 4 * plane, 4);
  threads.for_ranges(0, window.height, kGrain, [&](int begin, int end) {
    std::vector<float> amount;
    for (int j = begin; j < end; ++j) {
      float* out =
          texels.data() + 4 * static_cast<std::size_t>(window.width) * static_cast<std::size_t>(j);
      for (int k = 0; k < canvas.layers(); ++k) {
        for (int c = 0; c < channels; ++c) {
          rows.read(pigment_plane(k, 4 * plane + c), j, amount);
          for (std::size_t i = 0; i < amount.size(); ++i)
            out[4 * i + static_cast<std::size_t>(c)] += amount[i];
        }
      }
    }
  });
}

}  // namespace pentimento
