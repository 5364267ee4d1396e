#include "core/detail/flow/film_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/kernel.h"
#include "core/detail/flow/even_edges.h"
#include "core/detail/flow/profile_mean.h"
#include "core/detail/flow/smooth_field.h"

namespace pentimento {

namespace {
constexpr float kBare = 0.02f;  // share of the fullest cell around: less is no film
constexpr int kFits = 2;        // of the contour
constexpr int kWidenings = 2;   // of the contour where it leaves too little of a cell
constexpr int kFilmPasses = 3;  // of the film
constexpr int kTap = 2;         // cells on each side that the mean of a spline looks at
constexpr int kEven = kFits * kTap + kEvenReach;     // cells from the border that are even
constexpr int kWidened = kEven + kWidenings * kTap;  // and wide enough
constexpr int kAround = FilmSpline::kMargin + kWidened + kFilmPasses * kTap + 1;
constexpr float kLeastProfile = 1e-3f;  // keeps a cell outside the contour from dividing by 0
constexpr float kMayBeThin = 0.8f;      // coverage; fuller cells reach far enough out
constexpr float kLeastShare = 0.25f;    // of a wet cell that lies inside the contour
constexpr float kMost = 4;              // the film stays within a quarter and four times the depth
// Where B(f) is more than this, no point of the cell has W below 0.99 and M is 1: even the corners
// of the five by five cells have a weight of 7e-6.
constexpr float kWhole = 1 - 1e-6f;

/// How full of film n cells of a row are, f of the header before it is fitted.
PENTIMENTO_KERNEL
void find_fill_row(const float* cell, std::ptrdiff_t row, int n, float* __restrict fill) {
  const float *above = cell - row, *below = cell + row;
  for (int x = 0; x < n; ++x) {
    float most = cell[x];
    for (int i = -1; i <= 1; ++i) {
      const float values[] = {above[x + i], cell[x + i], below[x + i]};
      for (const float v : values) most = v > most ? v : most;
    }
    const float beside = cell[x - 1] < cell[x + 1] ? cell[x - 1] : cell[x + 1];
    const float along = above[x] < below[x] ? above[x] : below[x];
    const float least = beside < along ? beside : along;
    const float share = cell[x] / (most > 0 ? most : 1.0f);
    fill[x] = cell[x] > 0 ? (least < kBare * most ? share : 1.0f) : 0.0f;
  }
}

/// B: means along the rows, then along the columns, of the cells that are at least `margin` away
/// from the border, margin >= kTap. Others stay as they are.
std::vector<float> spline_means(const std::vector<float>& value, int width, int height,
                                int margin) {
  constexpr std::array<float, 3> kWeight = {230.0f / 384, 76.0f / 384, 1.0f / 384};
  const auto blur = [&](const std::vector<float>& in, std::ptrdiff_t step, int y0) {
    std::vector<float> out = in;
    for (int y = y0; y < height - y0; ++y)
      for (int x = margin; x < width - margin; ++x) {
        const float* v = in.data() + static_cast<std::ptrdiff_t>(y) * width + x;
        out[static_cast<std::size_t>(y * width + x)] = kWeight[0] * v[0] +
                                                       kWeight[1] * (v[-step] + v[step]) +
                                                       kWeight[2] * (v[-2 * step] + v[2 * step]);
      }
    return out;
  };
  return blur(blur(value, 1, margin - kTap), width, margin);
}
}  // namespace

FilmSpline::FilmSpline(const Field<float>& plane, const CellBox& box)
    : x0_(box.x0 - kAround),
      y0_(box.y0 - kAround),
      width_(box.width() + 2 * kAround),
      height_(box.height() + 2 * kAround) {
  held_ = read(plane);
  fit(plane, held_, held_);
}

FilmSpline::FilmSpline(const Field<float>& pigment, const FilmSpline& film)
    : x0_(film.x0_), y0_(film.y0_), width_(film.width_), height_(film.height_) {
  fit(pigment, read(pigment), film.held_);
}

/// What the cells hold.
std::vector<float> FilmSpline::read(const Field<float>& plane) const {
  std::vector<float> held;
  held.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = y0_; y < y0_ + height_; ++y)
    for (int x = x0_; x < x0_ + width_; ++x)
      held.push_back(
          plane(std::clamp(x, 0, plane.width() - 1), std::clamp(y, 0, plane.height() - 1)));
  return held;
}

/// `film`: what the cells hold of the film.
void FilmSpline::fit(const Field<float>& plane, const std::vector<float>& held,
                     const std::vector<float>& film) {
  fill_coverage(held, plane.width(), plane.height());
  fit_contour(held, film);
  // The film is adjusted until the spline's means are what the cells hold.
  film_ = held;
  const std::vector<float> spread = spline_means(coverage_, width_, height_, kWidened + kTap);
  const std::vector<std::size_t> edge = cells_where(
      kWidened + kTap, [&](std::size_t cell) { return held[cell] > 0 && spread[cell] < kWhole; });
  const std::vector<float> means = profile_means(edge);
  std::vector<float> profile(held.size(), 1.0f);
  for (std::size_t e = 0; e < edge.size(); ++e) profile[edge[e]] = means[e];
  for (int pass = 1; pass <= kFilmPasses; ++pass)
    sharpen(held, profile, spread, kWidened + pass * kTap);
}

/// f from what the cells hold.
void FilmSpline::fit_contour(const std::vector<float>& held, const std::vector<float>& film) {
  // Inside a film, and far from any, there is no contour.
  const auto [least, most] = std::minmax_element(coverage_.begin(), coverage_.end());
  if (*least == 1 || *most == 0) return;
  // The contour comes as far as the cells at the edge need.
  const std::vector<float> mean = spline_means(held, width_, height_, kTap);
  for (int fit = 1; fit <= kFits; ++fit) fit_coverage(held, mean, fit * kTap);
  // It is even along the film's edge, and leaves something of each cell there.
  const std::vector<float> fitted = std::move(coverage_);
  coverage_ = even_edges(fitted, film, width_, height_);
  for (int pass = 1; pass <= kWidenings; ++pass) widen(held, film, kEven + pass * kTap);
}

/// f before it is fitted. The outermost cells lack neighbours and have the same as those inside
/// them.
void FilmSpline::fill_coverage(const std::vector<float>& held, int canvas_width,
                               int canvas_height) {
  coverage_.assign(held.size(), 0.0f);
  for (int y = 1; y < height_ - 1; ++y) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * width_ + 1;
    find_fill_row(held.data() + first, width_, width_ - 2, coverage_.data() + first);
  }
  // So have cells beyond the canvas, which repeat the outermost cells of it.
  for (int y = y0_; y < y0_ + height_; ++y)
    for (int x = x0_; x < x0_ + width_; ++x) {
      const int px =
          std::clamp(x, std::max(0, x0_ + 1), std::min(canvas_width, x0_ + width_ - 1) - 1);
      const int py =
          std::clamp(y, std::max(0, y0_ + 1), std::min(canvas_height, y0_ + height_ - 1) - 1);
      if (px != x || py != y) coverage_[at(x, y)] = coverage_[at(px, py)];
    }
}

/// One pass over the cells that are at least `margin` away from the border. `mean`: B(d).
void FilmSpline::fit_coverage(const std::vector<float>& held, const std::vector<float>& mean,
                              int margin) {
  const std::vector<float> spread = spline_means(coverage_, width_, height_, margin);
  const std::vector<std::size_t> edge =
      cells_where(margin, [&](std::size_t i) { return held[i] > 0 && coverage_[i] < 1; });
  const std::vector<float> profile = profile_means(edge);
  for (std::size_t e = 0; e < edge.size(); ++e) {
    const std::size_t i = edge[e];
    const float holds = std::max(profile[e], kLeastProfile) * mean[i];
    const float factor = std::clamp(std::sqrt(held[i] * spread[i] / holds), 0.5f, 2.0f);
    coverage_[i] = std::min(coverage_[i] * factor, 1.0f);
  }
}

/// One pass over the cells that are at least `margin` away from the border.
void FilmSpline::widen(const std::vector<float>& held, const std::vector<float>& film, int margin) {
  const std::vector<std::size_t> thin = cells_where(margin, [&](std::size_t i) {
    return held[i] > 0 && coverage_[i] < kMayBeThin && bare_beside(film, i);
  });
  const std::vector<float> profile = profile_means(thin);
  for (std::size_t e = 0; e < thin.size(); ++e) {
    const float lacks = kLeastShare / std::max(profile[e], kLeastProfile);
    const float factor = std::clamp(std::sqrt(lacks), 1.0f, 2.0f);
    coverage_[thin[e]] = std::min(coverage_[thin[e]] * factor, 1.0f);
  }
}

/// Whether one of the 3 x 3 cells around is bare.
bool FilmSpline::bare_beside(const std::vector<float>& film, std::size_t cell) const {
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const std::ptrdiff_t beside = static_cast<std::ptrdiff_t>(cell) + j * width_ + i;
      if (!(film[static_cast<std::size_t>(beside)] > 0)) return true;
    }
  return false;
}

/// The cells that are at least `margin` away from the border and for which holds(cell) is true.
template <typename Holds>
std::vector<std::size_t> FilmSpline::cells_where(int margin, const Holds& holds) const {
  std::vector<std::size_t> cells;
  for (int y = margin; y < height_ - margin; ++y)
    for (int x = margin; x < width_ - margin; ++x) {
      const std::size_t cell = static_cast<std::size_t>(y * width_ + x);
      if (holds(cell)) cells.push_back(cell);
    }
  return cells;
}

/// M, the share that the edge's profile lets each cell hold.
std::vector<float> FilmSpline::profile_means(const std::vector<std::size_t>& cells) const {
  std::vector<float> profile(cells.size());
  CoverageAround around;
  for (std::size_t first = 0; first < cells.size(); first += kProfileBatch) {
    const std::size_t n = std::min<std::size_t>(kProfileBatch, cells.size() - first);
    for (std::size_t e = 0; e < n; ++e) {
      const float* middle = coverage_.data() + cells[first + e];
      std::size_t k = 0;
      for (int j = -kProfileReach; j <= kProfileReach; ++j)
        for (int i = -kProfileReach; i <= kProfileReach; ++i, ++k)
          around[k][e] = middle[static_cast<std::ptrdiff_t>(j) * width_ + i];
    }
    profile_mean_row(around, static_cast<int>(n), profile.data() + first);
  }
  return profile;
}

/// One pass over the cells that are at least `margin` away from the border.
void FilmSpline::sharpen(const std::vector<float>& held, const std::vector<float>& profile,
                         const std::vector<float>& spread, int margin) {
  const std::vector<float> mean = spline_means(film_, width_, height_, margin);
  for (int y = margin; y < height_ - margin; ++y)
    for (int x = margin; x < width_ - margin; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * width_ + x);
      const float holds = profile[i] * mean[i];
      if (!(holds > 0)) continue;
      const float factor = std::clamp(held[i] * spread[i] / holds, 0.5f, 2.0f);
      film_[i] = std::clamp(film_[i] * factor, held[i] / kMost, held[i] * kMost);
    }
}

}  // namespace pentimento
