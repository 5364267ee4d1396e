#include "replay/compare/convolve.h"

#include <algorithm>

namespace pentimento {

Field<float> convolve(FieldView<const float> in, const Taps& across, const Taps& down,
                      const Threads& threads) {
  const int width = in.width(), height = in.height();
  Field<float> rows(width, height);
  const int rx = static_cast<int>(across.size()) / 2;
  threads.for_rows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = -rx; k <= rx; ++k)
        sum += across[static_cast<std::size_t>(k + rx)] *
               static_cast<double>(in(std::clamp(x + k, 0, width - 1), y));
      rows(x, y) = static_cast<float>(sum);
    }
  });
  Field<float> out(width, height);
  const int ry = static_cast<int>(down.size()) / 2;
  threads.for_rows(height, [&](int y) {
    std::vector<double> sum(static_cast<std::size_t>(width), 0.0);
    for (int k = -ry; k <= ry; ++k) {
      const float* from = rows.row(std::clamp(y + k, 0, height - 1));
      const double weight = down[static_cast<std::size_t>(k + ry)];
      for (int x = 0; x < width; ++x)
        sum[static_cast<std::size_t>(x)] += weight * static_cast<double>(from[x]);
    }
    for (int x = 0; x < width; ++x)
      out(x, y) = static_cast<float>(sum[static_cast<std::size_t>(x)]);
  });
  return out;
}

}  // namespace pentimento
