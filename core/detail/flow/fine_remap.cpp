#include "core/detail/flow/fine_remap.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"

namespace pentimento {

namespace {
/// How much of its source cell lies before each edge.
PENTIMENTO_KERNEL
void find_shares(const float* position, const int* cell, int edges, float* __restrict share) {
  for (int j = 0; j < edges; ++j) {
    const float low = position[cell[j]], high = position[cell[j] + 1];
    const float part = (static_cast<float>(j) - low) / (high - low);
    const float some = part < 0 ? 0.0f : part;
    share[j] = some > 1 ? 1.0f : some;
  }
}

/// The most cells between the sources of two edges side by side.
PENTIMENTO_KERNEL
int most_apart(const int* cell, int edges) {
  int most = 0;
  for (int j = 1; j < edges; ++j) {
    const int apart = cell[j] - cell[j - 1];
    most = apart > most ? apart : most;
  }
  return most;
}

/// Whether the sources of `n` edges and of the one behind them lie in cells side by side.
PENTIMENTO_KERNEL
bool is_in_step(const int* cell, int n) {
  int off = 0;
  for (int j = 0; j < n; ++j) off |= cell[j + 1] - cell[j] - 1;
  return off == 0;
}

/// FineSources::near of the piece whose first edge has `cell`, in a line of `cells`: none where
/// cells would be read beyond the line's ghosts.
PENTIMENTO_KERNEL
int near_of(const int* cell, int cells) {
  int least = cell[0], most = cell[0];
  for (int j = 0; j < kEdgesTogether; ++j) {
    const int first = cell[j] - j;
    least = first < least ? first : least;
    most = first > most ? first : most;
  }
  return most - least <= 1 && least >= 0 && least + kEdgesTogether + 1 <= cells ? least : kNotNear;
}

/// part(i, s) of an edge (fine_remap.h), from the amounts around i.
inline float part_of(float s, float before, float here, float after) {
  const float slope = conservative::limited_mc(here - before, after - here);
  return s * (here - 0.5f * slope * (1 - s));
}

/// The parts of `n` edges.
PENTIMENTO_KERNEL
void find_parts(const int* cell, const float* share, const float* m, int n,
                float* __restrict part) {
  for (int j = 0; j < n; ++j) {
    const int i = cell[j];
    part[j] = part_of(share[j], m[i - 1], m[i], m[i + 1]);
  }
}

/// The same for kEdgesTogether edges whose sources are in step: `m` of the first one's.
PENTIMENTO_KERNEL
void find_parts_in_step(const float* share, const float* m, float* __restrict part) {
  for (int j = 0; j < kEdgesTogether; ++j) part[j] = part_of(share[j], m[j - 1], m[j], m[j + 1]);
}

/// The same for kEdgesTogether edges whose sources are near: `m` of the cell `near`. Vectors read
/// both cells that an edge's source may be, which is quicker than to look it up.
PENTIMENTO_KERNEL
void find_parts_near(const int* cell, int near, const float* share, const float* m,
                     float* __restrict part) {
  for (int j = 0; j < kEdgesTogether; ++j) {
    const bool on = cell[j] != near + j;  // one more
    const float a = m[j - 1], b = m[j], c = m[j + 1], d = m[j + 2];
    part[j] = part_of(share[j], on ? b : a, on ? c : b, on ? d : c);
  }
}

/// The amount between two edges, for cells whose edges come from at most two cells apart.
PENTIMENTO_KERNEL
void sum_between(const int* cell, const float* m, const float* part, int cells,
                 float* __restrict out) {
  for (int j = 0; j < cells; ++j) {
    const int i = cell[j], apart = cell[j + 1] - i;
    float sum = part[j + 1] - part[j];
    sum += apart > 0 ? m[i] : 0.0f;
    sum += apart > 1 ? m[i + 1] : 0.0f;
    out[j] = sum > 0 ? sum : 0.0f;
  }
}

/// The same for kEdgesTogether cells whose edges are in step: `m` of the first one's source.
PENTIMENTO_KERNEL
void sum_in_step(const float* m, const float* part, float* __restrict out) {
  for (int j = 0; j < kEdgesTogether; ++j) {
    const float sum = part[j + 1] - part[j] + m[j];
    out[j] = sum > 0 ? sum : 0.0f;
  }
}

/// The same for kEdgesTogether cells whose edges are near: `m` of the cell `near`.
PENTIMENTO_KERNEL
void sum_near(const int* cell, int near, const float* m, const float* part, float* __restrict out) {
  for (int j = 0; j < kEdgesTogether; ++j) {
    const bool on = cell[j] != near + j;
    const int apart = cell[j + 1] - cell[j];
    const float b = m[j], c = m[j + 1], d = m[j + 2];
    const float here = on ? c : b, after = on ? d : c;
    float sum = part[j + 1] - part[j];
    sum += apart > 0 ? here : 0.0f;
    sum += apart > 1 ? after : 0.0f;
    out[j] = sum > 0 ? sum : 0.0f;
  }
}

float sum_far(const float* m, int from, int to, float sum) {
  for (int i = from; i < to; ++i) sum += m[i];
  return sum > 0 ? sum : 0.0f;
}
}  // namespace

void find_sources(std::span<const float> position, FineSources& sources) {
  const std::size_t edges = position.size();
  sources.cell.resize(edges);
  sources.share.resize(edges);
  sources.most = 0;
  // Both ascend: one walk finds the cell of each edge.
  std::size_t i = 0;
  for (std::size_t j = 0; j + 1 < edges; ++j) {
    const float at = static_cast<float>(j);
    while (i + 2 < edges && position[i + 1] <= at) ++i;
    sources.cell[j] = static_cast<int>(i);
  }
  find_shares(position.data(), sources.cell.data(), static_cast<int>(edges) - 1,
              sources.share.data());
  sources.cell[edges - 1] = static_cast<int>(edges) - 2;
  sources.share[edges - 1] = 1;
  sources.most = most_apart(sources.cell.data(), static_cast<int>(edges));
  sources.in_step.clear();
  sources.near.clear();
  constexpr std::size_t kTogether = kEdgesTogether;
  for (std::size_t j = 0; j < edges; j += kTogether) {
    const int* cell = sources.cell.data() + j;
    const bool whole = j + kTogether < edges;
    sources.in_step.push_back(whole && is_in_step(cell, kEdgesTogether) ? 1 : 0);
    sources.near.push_back(whole ? near_of(cell, static_cast<int>(edges) - 1) : kNotNear);
  }
}

void remap_line(const FineSources& sources, std::span<const float> amount, std::span<float> part,
                std::span<float> out) {
  const float* m = amount.data() + 1;
  const int cells = static_cast<int>(out.size());
  const int* cell = sources.cell.data();
  const float* share = sources.share.data();
  const auto in_step = [&](int j) {
    return sources.in_step[static_cast<std::size_t>(j / kEdgesTogether)] != 0;
  };
  const auto near = [&](int j) {
    return sources.near[static_cast<std::size_t>(j / kEdgesTogether)];
  };
  // Near cells in whole vectors, which lie side by side where the edges are in step.
  for (int j = 0; j <= cells; j += kEdgesTogether) {
    float* to = part.data() + j;
    if (in_step(j)) {
      find_parts_in_step(share + j, m + cell[j], to);
    } else if (near(j) != kNotNear) {
      find_parts_near(cell + j, near(j), share + j, m + near(j), to);
    } else {
      find_parts(cell + j, share + j, m, std::min(kEdgesTogether, cells + 1 - j), to);
    }
  }
  for (int j = 0; j < cells; j += kEdgesTogether) {
    const float* from = part.data() + j;
    float* to = out.data() + j;
    if (in_step(j)) {
      sum_in_step(m + cell[j], from, to);
    } else if (near(j) != kNotNear) {
      sum_near(cell + j, near(j), m + near(j), from, to);
    } else {
      sum_between(cell + j, m, from, std::min(kEdgesTogether, cells - j), to);
    }
  }
  // Then the few cells whose edges come from further apart.
  if (sources.most <= 2) return;
  for (std::size_t j = 0; j < out.size(); ++j)
    if (cell[j + 1] - cell[j] > 2) out[j] = sum_far(m, cell[j], cell[j + 1], part[j + 1] - part[j]);
}

}  // namespace pentimento
