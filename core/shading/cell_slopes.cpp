#include "core/shading/cell_slopes.h"

#include "core/base/check.h"
#include "core/base/kernel.h"

namespace pentimento {
namespace {

constexpr int kRowsTogether = 8;  // a task of some tens of microseconds

/// Heights and thicknesses of a row of cells and of the rows around it, in pairs; of the middle row
/// one cell to each side is read.
struct ReliefRow {
  const float* above;
  const float* here;
  const float* below;
};

PENTIMENTO_KERNEL
void slope_row(const ReliefRow& relief, float across, float down, int n, float* __restrict out) {
  const ReliefRow r = relief;
  for (int i = 0; i < n; ++i) {
    out[4 * i] = r.here[2 * i];
    out[4 * i + 1] = r.here[2 * i + 1];
    out[4 * i + 2] = 0.5f * (r.here[2 * i + 2] - r.here[2 * i - 2]) * across;
    out[4 * i + 3] = 0.5f * (r.below[2 * i] - r.above[2 * i]) * down;
  }
}

}  // namespace

void pack_slopes(const PackedRelief& relief, const std::array<float, 2>& per_cell,
                 const Threads& threads, std::vector<float>& out) {
  PENTIMENTO_CHECK(relief.border >= 1);
  const auto width = static_cast<std::size_t>(relief.window.width);
  const auto border = static_cast<std::size_t>(relief.border);
  const std::size_t stride = 2 * (width + 2 * border);
  out.resize(4 * width * static_cast<std::size_t>(relief.window.height));
  threads.for_ranges(0, relief.window.height, kRowsTogether, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = static_cast<std::size_t>(y);
      const float* here = relief.texels.data() + (border + row) * stride + 2 * border;
      slope_row({here - stride, here, here + stride}, per_cell[0], per_cell[1], relief.window.width,
                out.data() + 4 * width * row);
    }
  });
}

}  // namespace pentimento
