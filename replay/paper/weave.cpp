#include "replay/paper/weave.h"

#include <algorithm>
#include <vector>

#include "core/base/approx.h"
#include "core/base/kernel.h"
#include "core/base/random.h"

namespace pentimento {

namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr int kMeanSamples = 16;

/// Along a row: what its cells have of their columns' profiles.
struct WeaveColumns {
  const double* body;
  const double* sway;
  const double* wave;
};

/// `body`, `sway`, `wave`: the row's own profile.
PENTIMENTO_KERNEL
void weave_row(const WeaveColumns& columns, double body, double sway, double wave, int n,
               float* __restrict out) {
  const WeaveColumns u = columns;
  for (int i = 0; i < n; ++i) {
    const double warp = u.body[i] + u.sway[i] * wave;
    const double weft = body - sway * u.wave[i];
    out[i] = static_cast<float>(std::clamp((warp + weft) / 2, 0.0, 1.0));
  }
}
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

Weave::CellMeans Weave::cell_means(const WeaveShape& shape, Side side, int cells,
                                   double cells_per_repeat) {
  const double threads_per_cell = shape.threads / cells_per_repeat;
  const int samples = kMeanSamples * (1 + static_cast<int>(std::min(threads_per_cell, 1e4)));
  CellMeans means;
  for (int i = 0; i < cells; ++i) {
    Profile mean;
    for (int k = 0; k < samples; ++k) {
      const Profile p = profile_at(shape, side, (i + (k + 0.5) / samples) / cells_per_repeat);
      mean.body += p.body / samples;
      mean.sway += p.sway / samples;
      mean.wave += p.wave / samples;
    }
    means.body.push_back(mean.body);
    means.sway.push_back(mean.sway);
    means.wave.push_back(mean.wave);
  }
  return means;
}
Weave::Weave(const WeaveShape& shape, const RepeatGrid& grid)
    : columns_(cell_means(shape, Side::kWarp, grid.width, grid.cells_per_repeat_x)),
      rows_(cell_means(shape, Side::kWeft, grid.height, grid.cells_per_repeat_y)) {}

void Weave::row(int x, int y, std::span<float> out) const {
  const auto j = static_cast<std::size_t>(y);
  weave_row({columns_.body.data() + x, columns_.sway.data() + x, columns_.wave.data() + x},
            rows_.body[j], rows_.sway[j], rows_.wave[j], static_cast<int>(out.size()), out.data());
}

}  // namespace pentimento
