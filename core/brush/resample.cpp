#include "core/brush/resample.h"

#include <algorithm>

namespace pentimento {

namespace {
/// Mean of `count` values at `stride` over [from, to), positions in values.
double mean_over(const float* values, std::ptrdiff_t stride, int count, double from, double to) {
  double sum = 0;
  const int last = std::min(count - 1, static_cast<int>(to));
  for (int i = static_cast<int>(from); i <= last; ++i) {
    const double share =
        std::min(to, static_cast<double>(i + 1)) - std::max(from, static_cast<double>(i));
    if (share > 0) sum += share * static_cast<double>(values[i * stride]);
  }
  return sum / (to - from);
}
}  // namespace

Field<float> resample_area(const Field<float>& in, int width, int height) {
  PENTIMENTO_CHECK(!in.empty() && width >= 1 && height >= 1);
  const double step_x = static_cast<double>(in.width()) / width;
  const double step_y = static_cast<double>(in.height()) / height;
  Field<float> rows(width, in.height());
  for (int y = 0; y < in.height(); ++y)
    for (int x = 0; x < width; ++x)
      rows(x, y) =
          static_cast<float>(mean_over(in.row(y), 1, in.width(), x * step_x, (x + 1) * step_x));
  const std::ptrdiff_t stride = rows.view().stride();
  Field<float> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      out(x, y) = static_cast<float>(
          mean_over(rows.row(0) + x, stride, in.height(), y * step_y, (y + 1) * step_y));
  return out;
}

}  // namespace pentimento
