#include "core/detail/flow/film_spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/detail/flow/level_rows.h"
#include "core/detail/flow/smooth_field.h"

namespace pentimento {

namespace {
constexpr float kBare = 0.02f;  // share of the fullest cell around: less is no film
constexpr int kFits = 2;        // of the contour
constexpr int kFilmPasses = 3;  // of the film
constexpr int kTap = 2;         // cells on each side that the mean of a spline looks at
constexpr int kAround = FilmSpline::kMargin + (kFits + kFilmPasses) * kTap;
constexpr float kLeastProfile = 1e-3f;  // keeps a cell outside the contour from dividing by 0
constexpr float kMost = 4;              // the film stays within a quarter and four times the depth
// Where B(f) is more than this, no point of the cell has W below 0.99 and M is 1: even the corners
// of the five by five cells have a weight of 7e-6.
constexpr float kWhole = 1 - 1e-6f;

float fill_at(const Field<float>& plane, int x, int y) {
  const int right = plane.width() - 1, bottom = plane.height() - 1;
  const float here = plane(x, y);
  if (!(here > 0)) return 0;
  float most = here;
  for (int j = std::max(0, y - 1); j <= std::min(bottom, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(right, x + 1); ++i)
      most = std::max(most, plane(i, j));
  const float least =
      std::min(std::min(plane(std::max(0, x - 1), y), plane(std::min(right, x + 1), y)),
               std::min(plane(x, std::max(0, y - 1)), plane(x, std::min(bottom, y + 1))));
  return least < kBare * most ? here / most : 1.0f;
}

/// B: means along the rows, then along the columns. Cells nearer than kTap to the border stay as
/// they are.
std::vector<float> spline_means(const std::vector<float>& value, int width, int height) {
  constexpr std::array<float, 3> kWeight = {230.0f / 384, 76.0f / 384, 1.0f / 384};
  const auto blur = [&](const std::vector<float>& in, std::ptrdiff_t step, int x0, int y0) {
    std::vector<float> out = in;
    for (int y = y0; y < height - y0; ++y)
      for (int x = x0; x < width - x0; ++x) {
        const float* v = in.data() + static_cast<std::ptrdiff_t>(y) * width + x;
        out[static_cast<std::size_t>(y * width + x)] = kWeight[0] * v[0] +
                                                       kWeight[1] * (v[-step] + v[step]) +
                                                       kWeight[2] * (v[-2 * step] + v[2 * step]);
      }
    return out;
  };
  return blur(blur(value, 1, kTap, 0), width, 0, kTap);
}

/// The four points along an axis of a cell where M is measured.
constexpr std::array<SplineTaps, 4> kPoints = {spline_taps(-0.375f), spline_taps(-0.125f),
                                               spline_taps(0.125f), spline_taps(0.375f)};
}  // namespace

FilmSpline::FilmSpline(const Field<float>& plane, const CellBox& box)
    : x0_(box.x0 - kAround),
      y0_(box.y0 - kAround),
      width_(box.width() + 2 * kAround),
      height_(box.height() + 2 * kAround) {
  const std::size_t cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  // What the cells hold, and how full each is of film.
  std::vector<float> held(cells);
  coverage_.resize(cells);
  std::size_t i = 0;
  for (int y = y0_; y < y0_ + height_; ++y)
    for (int x = x0_; x < x0_ + width_; ++x, ++i) {
      const int px = std::clamp(x, 0, plane.width() - 1), py = std::clamp(y, 0, plane.height() - 1);
      held[i] = plane(px, py);
      coverage_[i] = fill_at(plane, px, py);
    }
  // The contour comes as far as the cells at the edge need.
  const std::vector<float> mean = spline_means(held, width_, height_);
  for (int fit = 1; fit <= kFits; ++fit) fit_coverage(held, mean, fit * kTap);
  // The film is adjusted until the spline's means are what the cells hold.
  film_ = held;
  const std::vector<float> spread = spline_means(coverage_, width_, height_);
  const std::vector<float> profile = profile_means(held, spread);
  for (int pass = 1; pass <= kFilmPasses; ++pass)
    sharpen(held, profile, spread, (kFits + pass) * kTap);
}

/// One pass over the cells that are at least `margin` away from the border. `mean`: B(d).
void FilmSpline::fit_coverage(const std::vector<float>& held, const std::vector<float>& mean,
                              int margin) {
  const std::vector<float> spread = spline_means(coverage_, width_, height_);
  const std::vector<float> profile = profile_means(held, spread);
  for (int y = margin; y < height_ - margin; ++y)
    for (int x = margin; x < width_ - margin; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * width_ + x);
      if (!(held[i] > 0) || !(coverage_[i] < 1)) continue;
      const float holds = std::max(profile[i], kLeastProfile) * mean[i];
      const float factor = std::clamp(std::sqrt(held[i] * spread[i] / holds), 0.5f, 2.0f);
      coverage_[i] = std::min(coverage_[i] * factor, 1.0f);
    }
}

/// M, the share that the edge's profile lets each cell hold; whole cells need no measuring.
/// `spread`: B(f).
std::vector<float> FilmSpline::profile_means(const std::vector<float>& held,
                                             const std::vector<float>& spread) const {
  std::vector<float> profile(held.size(), 1.0f);
  for (int y = kTap; y < height_ - kTap; ++y)
    for (int x = kTap; x < width_ - kTap; ++x) {
      const std::size_t cell = static_cast<std::size_t>(y * width_ + x);
      if (held[cell] > 0 && spread[cell] < kWhole) profile[cell] = profile_mean(cell);
    }
  return profile;
}

/// M of a cell, from 4 x 4 points: along the rows first, then down.
float FilmSpline::profile_mean(std::size_t cell) const {
  std::array<std::array<float, kPoints.size()>, 2 * kTap + 1> along{};
  for (int j = -kTap; j <= kTap; ++j) {
    const float* row = coverage_.data() + static_cast<std::ptrdiff_t>(cell) + j * width_;
    std::array<float, kPoints.size()>& sums = along[static_cast<std::size_t>(j + kTap)];
    for (std::size_t p = 0; p < kPoints.size(); ++p)
      for (int i = 0; i < 4; ++i)
        sums[p] += kPoints[p].weight[static_cast<std::size_t>(i)] * row[kPoints[p].first + i];
  }
  float sum = 0;
  for (const SplineTaps& down : kPoints) {
    for (std::size_t p = 0; p < kPoints.size(); ++p) {
      float wet = 0;
      for (std::size_t j = 0; j < 4; ++j)
        wet += down.weight[j] * along[static_cast<std::size_t>(down.first + kTap) + j][p];
      sum += edge_profile(wet);
    }
  }
  return sum / 16;
}

/// One pass over the cells that are at least `margin` away from the border.
void FilmSpline::sharpen(const std::vector<float>& held, const std::vector<float>& profile,
                         const std::vector<float>& spread, int margin) {
  const std::vector<float> mean = spline_means(film_, width_, height_);
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
