#include "replay/paper/weave.h"

#include <algorithm>
#include <vector>

#include "core/base/approx.h"
#include "core/base/random.h"

namespace pentimento {

namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr int kMeanSamples = 16;

}  // namespace

Weave::Profile Weave::profile_at(const WeaveShape& shape, Side side, double u) {
  const double whole = u - static_cast<double>(static_cast<std::int64_t>(u));
  const double along = whole * shape.threads;
  const int thread = std::min(static_cast<int>(along), shape.threads - 1);
  const double s = approx::sin(kPi * (along - thread));
  const auto key = static_cast<std::uint64_t>(thread) * 2 + (side == Side::kWarp ? 0 : 1);
  const double thickness = 1 - shape.unevenness * static_cast<double>(random_uniform(
                                                      RandomPurpose::kPaperRelief, 0, key));
  const double sign = thread % 2 == 0 ? 1 : -1;
  return {thickness * s * s, sign * thickness * s * s, sign * s};
}

std::vector<Weave::Profile> Weave::cell_means(const WeaveShape& shape, Side side, int cells,
                                              double cells_per_repeat) {
  const double threads_per_cell = shape.threads / cells_per_repeat;
  const int samples = kMeanSamples * (1 + static_cast<int>(std::min(threads_per_cell, 1e4)));
  std::vector<Profile> means(static_cast<std::size_t>(cells));
  for (int i = 0; i < cells; ++i) {
    Profile& mean = means[static_cast<std::size_t>(i)];
    for (int k = 0; k < samples; ++k) {
      const Profile p = profile_at(shape, side, (i + (k + 0.5) / samples) / cells_per_repeat);
      mean.body += p.body / samples;
      mean.sway += p.sway / samples;
      mean.wave += p.wave / samples;
    }
  }
  return means;
}
Weave::Weave(const WeaveShape& shape, const RepeatGrid& grid)
    : columns_(cell_means(shape, Side::kWarp, grid.width, grid.cells_per_repeat_x)),
      rows_(cell_means(shape, Side::kWeft, grid.height, grid.cells_per_repeat_y)) {}

void Weave::row(int x, int y, std::span<float> out) const {
  const Profile& v = rows_[static_cast<std::size_t>(y)];
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Profile& u = columns_[static_cast<std::size_t>(x) + i];
    const double warp = u.body + u.sway * v.wave;
    const double weft = v.body - v.sway * u.wave;
    out[i] = static_cast<float>(std::clamp((warp + weft) / 2, 0.0, 1.0));
  }
}

}  // namespace pentimento
