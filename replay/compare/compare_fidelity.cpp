// A canvas against one several times finer: is it the same painting?

#include <fmt/format.h>

#include "replay/compare/compare.h"
#include "replay/compare/plane_difference.h"
#include "replay/compare/reduce_canvas.h"

namespace pentimento {

namespace {

/// to += factor * plane
void add(const Field<float>& plane, float factor, Field<float>& to) {
  for (int y = 0; y < to.height(); ++y)
    for (int x = 0; x < to.width(); ++x) to(x, y) += factor * plane(x, y);
}

/// Both canvases on the coarser one's grid.
class Pair {
 public:
  Pair(const CanvasSource& coarse, const CanvasSource& fine, const Threads& threads)
      : coarse_(coarse),
        fine_(fine),
        factor_(fine.geometry().width / coarse.geometry().width),
        threads_(threads) {}

  struct PlanePair {
    Field<float> a, b;
  };
  PlanePair read(PlaneId plane) const {
    return {block_means(coarse_, plane, 1, threads_), block_means(fine_, plane, factor_, threads_)};
  }
  PlanePair zero() const {
    const CanvasGeometry& grid = coarse_.geometry();
    return {Field<float>(grid.width, grid.height), Field<float>(grid.width, grid.height)};
  }

 private:
  const CanvasSource& coarse_;
  const CanvasSource& fine_;
  int factor_;
  const Threads& threads_;
};

void add(const Pair::PlanePair& planes, float factor, Pair::PlanePair& to) {
  add(planes.a, factor, to.a);
  add(planes.b, factor, to.b);
}

void tell(const std::string& name, const Pair::PlanePair& planes, Comparison& out) {
  out.planes.push_back(fidelity(name, planes.a.view(), planes.b.view()));
}

}  // namespace

int whole_ratio(const CanvasGeometry& a, const CanvasGeometry& b) {
  const int factor = b.width / a.width;
  return factor >= 1 && b.width == factor * a.width && b.height == factor * a.height ? factor : 0;
}

void compare_reduced(const CanvasSource& coarse, const CanvasSource& fine,
                     const ChannelBasis& basis, const Threads& threads, Comparison& out) {
  const Pair pair(coarse, fine, threads);
  tell("/fluid/depth", pair.read({PlaneKind::kDepth}), out);
  Pair::PlanePair dried = pair.read({PlaneKind::kBase});
  add(pair.read({PlaneKind::kPaper}), -1.0f, dried);
  tell("dried paint", dried, out);
  Pair::PlanePair total = pair.zero();
  for (int c = 0; c < coarse.channels(); ++c) {
    Pair::PlanePair sum = pair.zero();
    for (int layer = 0; layer < coarse.layers(); ++layer) {
      const Pair::PlanePair planes = pair.read(pigment_plane(layer, c));
      tell(fmt::format("/layers/pigment[{},{}]", layer, c), planes, out);
      out.planes.back().locked = false;
      add(planes, 1.0f, sum);
    }
    tell("pigment " + basis.name[static_cast<std::size_t>(c)], sum, out);
    add(sum, basis.amount(c), total);
  }
  tell("pigment, total", total, out);
}

}  // namespace pentimento
