#include "replay/compare/reduce_canvas.h"

#include <vector>

namespace pentimento {

Field<float> block_means(const CanvasSource& canvas, PlaneId plane, int factor,
                         const Threads& threads) {
  const CanvasGeometry& fine = canvas.geometry();
  PENTIMENTO_CHECK(fine.width % factor == 0 && fine.height % factor == 0);
  Field<float> out(fine.width / factor, fine.height / factor);
  const auto columns = static_cast<std::size_t>(out.width());
  const double cells = static_cast<double>(factor) * factor;
  threads.for_rows(out.height(), [&](int y) {
    std::vector<float> row(static_cast<std::size_t>(fine.width));
    std::vector<double> sum(columns, 0.0);
    for (int j = 0; j < factor; ++j) {
      canvas.read(plane, 0, y * factor + j, row);
      const float* in = row.data();
      for (std::size_t x = 0; x < columns; ++x)
        for (int i = 0; i < factor; ++i) sum[x] += static_cast<double>(*in++);
    }
    for (std::size_t x = 0; x < columns; ++x) out.row(y)[x] = static_cast<float>(sum[x] / cells);
  });
  return out;
}

}  // namespace pentimento
