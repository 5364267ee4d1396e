#include "core/detail/flow/even_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr int kAcross = 2;                    // cells of a line on each side of its middle
constexpr int kAlong = kEvenReach - kAcross;  // lines on each side that the mean may take in
// Square cells: three lines at an edge that folds by a third of a cell a line.
constexpr float kMostBend = 1;
// Cells: a straight edge along an axis has 15, one at 45 degrees 10, a groove less than 5.
constexpr float kLeastFall = 5;
constexpr float kLeastCoverage = 0.1f;  // keeps what is wet inside the contour

/// Directions at an edge, as offsets in the plane.
struct EdgeFrame {
  std::ptrdiff_t outward;  // from a cell to the next one across the edge
  std::ptrdiff_t along;    // to the next one along it
};

/// Which of n cells of a row are at the film's edge or beside it, and have coverage around them.
PENTIMENTO_KERNEL
void find_edge_row(const float* coverage, const float* film, std::ptrdiff_t row, int n,
                   unsigned char* __restrict edge) {
  for (int x = 0; x < n; ++x) {
    float least = film[x], most = coverage[x];
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const float f = film[j * row + x + i], c = coverage[j * row + x + i];
        least = f < least ? f : least;
        most = c > most ? c : most;
      }
    edge[x] = static_cast<unsigned char>(most > 0) & static_cast<unsigned char>(!(least > 0));
  }
}

/// The directions at a cell, if the film falls off there.
std::optional<EdgeFrame> frame_at(const float* cell, std::ptrdiff_t row) {
  float fall_x = 0, fall_y = 0;
  for (int j = -kAcross; j <= kAcross; ++j)
    for (int i = -kAcross; i <= kAcross; ++i) {
      fall_x -= static_cast<float>(i) * cell[j * row + i];
      fall_y -= static_cast<float>(j) * cell[j * row + i];
    }
  if (std::max(std::abs(fall_x), std::abs(fall_y)) < kLeastFall) return std::nullopt;
  if (std::abs(fall_x) >= std::abs(fall_y)) return EdgeFrame{fall_x > 0 ? 1 : -1, row};
  return EdgeFrame{fall_y > 0 ? row : -row, 1};
}

/// H: how many cells of the line through `middle` the film covers. 0 where the edge does not cross
/// the line: its innermost cell is not whole, or no cell is bare.
float covered(const float* middle, std::ptrdiff_t outward) {
  constexpr int kCells = 2 * kAcross + 1;
  if (middle[-kAcross * outward] < 1) return 0;
  float sum = 0, last = 1;
  for (int i = -kAcross; i <= kAcross; ++i) {
    last = std::min(last, middle[i * outward]);
    sum += last;
  }
  return sum < kCells ? sum : 0.0f;
}

/// The mean of H along the edge; `here` is H(0).
float mean_covered(const float* cell, const EdgeFrame& frame, float here) {
  // The lines on both sides, as far as the edge goes on.
  float pair[kAlong + 1] = {};
  int reach = 0;
  while (reach < kAlong) {
    const std::ptrdiff_t step = (reach + 1) * frame.along;
    const float after = covered(cell + step, frame.outward);
    const float before = covered(cell - step, frame.outward);
    if (!(after > 0) || !(before > 0)) break;
    if ((after - here) * (before - here) > kMostBend) break;
    pair[++reach] = after + before - 2 * here;
  }
  // Their mean, the nearest with the most weight.
  float sum = 0;
  for (int k = 1; k <= reach; ++k) sum += static_cast<float>(reach + 1 - k) * pair[k];
  return here + sum / static_cast<float>((reach + 1) * (reach + 1));
}

/// f' of a cell.
float even_cell(const float* cell, std::ptrdiff_t row) {
  const std::optional<EdgeFrame> frame = frame_at(cell, row);
  if (!frame || !(cell[-frame->outward] > 0)) return cell[0];
  const float here = covered(cell, frame->outward);
  if (!(here > 0)) return cell[0];
  const float within = mean_covered(cell, *frame, here) - kAcross;
  return std::clamp(within, cell[0] > 0 ? kLeastCoverage : 0.0f, 1.0f);
}
}  // namespace

std::vector<float> even_edges(const std::vector<float>& coverage, const std::vector<float>& film,
                              int width, int height) {
  std::vector<float> even = coverage;
  const int inner = width - 2 * kEvenReach;
  std::vector<unsigned char> edge(static_cast<std::size_t>(std::max(0, inner)));
  for (int y = kEvenReach; y < height - kEvenReach; ++y) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * width + kEvenReach;
    find_edge_row(coverage.data() + first, film.data() + first, width, inner, edge.data());
    for (int x = 0; x < inner; ++x)
      if (edge[static_cast<std::size_t>(x)] != 0)
        even[static_cast<std::size_t>(first + x)] = even_cell(coverage.data() + first + x, width);
  }
  return even;
}

}  // namespace pentimento
