#include "formats/png/filter.h"

#include <cstring>

namespace pentimento::png {

namespace {

constexpr int kFilters = 5;
using Row = const std::uint8_t*;

std::uint8_t paeth(int left, int above, int corner) {
  const int to_left = above - corner;  // distances of left + above - corner
  const int to_above = left - corner;
  const int to_corner = to_left + to_above;
  const int p = to_left < 0 ? -to_left : to_left;
  const int q = to_above < 0 ? -to_above : to_above;
  const int r = to_corner < 0 ? -to_corner : to_corner;
  const int nearer = q <= r ? above : corner;
  return static_cast<std::uint8_t>(p <= q && p <= r ? left : nearer);
}

/// `a`, `b`, `c`: left, above and above-left of each byte. One loop each, so that they vectorise.
void filter_all(Row x, Row a, Row b, Row c, std::size_t n, std::uint8_t* const out[kFilters]) {
  for (std::size_t i = 0; i < n; ++i) out[1][i] = static_cast<std::uint8_t>(x[i] - a[i]);
  for (std::size_t i = 0; i < n; ++i) out[2][i] = static_cast<std::uint8_t>(x[i] - b[i]);
  for (std::size_t i = 0; i < n; ++i)
    out[3][i] = static_cast<std::uint8_t>(x[i] - ((a[i] + b[i]) >> 1));
  for (std::size_t i = 0; i < n; ++i)
    out[4][i] = static_cast<std::uint8_t>(x[i] - paeth(a[i], b[i], c[i]));
}

std::uint32_t cost(Row bytes, std::size_t n) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int v = static_cast<std::int8_t>(bytes[i]);
    sum += static_cast<std::uint32_t>(v < 0 ? -v : v);
  }
  return sum;
}

}  // namespace

void filter_row(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above, int bpp,
                std::span<std::uint8_t> scratch, std::uint8_t* out) {
  const std::size_t n = row.size();
  const std::size_t first = static_cast<std::size_t>(bpp);
  std::uint8_t* filtered[kFilters] = {nullptr, scratch.data(), scratch.data() + n,
                                      scratch.data() + 2 * n, scratch.data() + 3 * n};
  // The first pixel has no left neighbour: zeros stand for it.
  for (std::size_t i = 0; i < first; ++i) {
    filtered[1][i] = row[i];
    filtered[2][i] = static_cast<std::uint8_t>(row[i] - above[i]);
    filtered[3][i] = static_cast<std::uint8_t>(row[i] - (above[i] >> 1));
    filtered[4][i] = filtered[2][i];
  }
  std::uint8_t* rest[kFilters] = {nullptr, filtered[1] + first, filtered[2] + first,
                                  filtered[3] + first, filtered[4] + first};
  filter_all(row.data() + first, row.data(), above.data() + first, above.data(), n - first, rest);

  int best = 0;
  const std::uint8_t* best_bytes = row.data();
  std::uint32_t best_cost = cost(row.data(), n);
  for (int f = 1; f < kFilters; ++f) {
    const std::uint32_t c = cost(filtered[f], n);
    if (c >= best_cost) continue;
    best = f;
    best_cost = c;
    best_bytes = filtered[f];
  }
  out[0] = static_cast<std::uint8_t>(best);
  std::memcpy(out + 1, best_bytes, n);
}

}  // namespace pentimento::png
