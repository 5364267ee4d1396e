#include "core/brush/tip.h"

#include <algorithm>
#include <cmath>

#include "core/base/kernel.h"
#include "core/brush/resample.h"
#include "core/brush/stamp_shares.h"

namespace pentimento {

namespace {
constexpr int kMasterSize = 256;  // a tip of 30 mm has texels of 0.12 mm, a bristle's width
constexpr int kPresses = 5;       // drawings from the lightest touch to all bristles down
constexpr int kDrynesses = 8;
constexpr float kWetFrac = 0.8f;                       // from here on all bristles give alike
constexpr float kEndsFrom = 0.65f, kEndsPerValue = 5;  // a tip's ends: values of 0.65 to 0.85
constexpr float kReachPerValue = 4;  // the side of a tip is where its value passes an eighth

/// FNV-1a of the name.
std::uint64_t seed_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

/// Which two of `count` evenly spaced points in [0,1] lie around `at`, and where `at` lies between
/// them.
struct TexelPlace {
  std::size_t low = 0, high = 0;
  float frac = 0;
  TexelPlace(float at, std::size_t count) {
    const float x = std::clamp(at, 0.0f, 1.0f) * static_cast<float>(count - 1);
    low = std::min(static_cast<std::size_t>(x), count - 1);
    high = std::min(low + 1, count - 1);
    frac = x - static_cast<float>(low);
  }
};

/// The step of a table before each of a row of places, and how far the place lies beyond it.
PENTIMENTO_KERNEL
void find_steps(float v0, float dv, int first, int n, int* __restrict step,
                float* __restrict beyond) {
  for (int i = 0; i < n; ++i) {
    const float v = v0 + dv * static_cast<float>(first + i);
    const float x =
        std::clamp((v + 0.5f) * BristleTable::kSteps, 0.0f, BristleTable::kSteps - 0.001f);
    const int whole = static_cast<int>(x);
    step[i] = whole;
    beyond[i] = x - static_cast<float>(whole);
  }
}

PENTIMENTO_KERNEL
void between_rows(const float* __restrict low, const float* __restrict high,
                  const float* __restrict beyond, int n, float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = low[i] + beyond[i] * (high[i] - low[i]);
}
}  // namespace

TipMap::TipMap(const Field<float>& map)
    : size_(map.width()), padded_(map.width() + 2, map.width() + 2) {
  for (int y = 0; y < size_; ++y) std::copy_n(map.row(y), size_, padded_.row(y + 1) + 1);
}

void BristleTable::row(float v0, float dv, int first, int n, float* out) const {
  PENTIMENTO_CHECK(n <= kMostInRow);
  std::array<int, kMostInRow> step;
  std::array<float, kMostInRow> beyond, low, high;
  find_steps(v0, dv, first, n, step.data(), beyond.data());
  // Processors look values up one by one; all else is vectors.
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    const float* at = value_.data() + step[i];
    low[i] = at[0];
    high[i] = at[1];
  }
  between_rows(low.data(), high.data(), beyond.data(), n, out);
}

BristleTable BristleTable::averaged(float width) const {
  // The integral of the linear pieces up to each step; beyond the table its ends go on.
  std::array<double, kSteps + 1> up_to{};
  const auto value = [&](std::size_t step) { return static_cast<double>(value_[step]); };
  for (std::size_t i = 0; i < kSteps; ++i)
    up_to[i + 1] = up_to[i] + 0.5 * (value(i) + value(i + 1));
  const auto integral = [&](double x) {
    const double inside = std::clamp(x, 0.0, static_cast<double>(kSteps));
    const std::size_t i = std::min(static_cast<std::size_t>(inside), std::size_t{kSteps - 1});
    const double t = inside - static_cast<double>(i);
    const double beyond = (x - inside) * value(x < 0 ? 0 : kSteps);
    return up_to[i] + t * (value(i) + 0.5 * t * (value(i + 1) - value(i))) + beyond;
  };
  BristleTable mean;
  const double half = 0.5 * static_cast<double>(width) * kSteps;
  for (int i = 0; i <= kSteps; ++i)
    mean[i] = static_cast<float>((integral(i + half) - integral(i - half)) / (2 * half));
  return mean;
}

Tip::Tip(const BrushDefinition& brush) {
  const std::uint64_t seed = seed_of(brush.name);
  Field<float> widest(kMasterSize, kMasterSize);
  const int presses = has_bristles(brush) ? kPresses : 1;
  for (int i = 0; i < presses; ++i) {
    const float press = presses == 1 ? 1 : static_cast<float>(i) / static_cast<float>(presses - 1);
    const Field<float> master = draw_tip(brush, kMasterSize, seed, press);
    add_press(master);
    for (int y = 0; y < kMasterSize; ++y)
      for (int x = 0; x < kMasterSize; ++x) widest(x, y) = std::max(widest(x, y), master(x, y));
  }
  if (brush.shape != TipShape::kTexture) find_extent(widest);
  fill_tables(brush, seed);
  fill_ends(widest);
  if (mean() > 0) list_texels(resample_area(widest, kReservoirColumns, kReservoirRows));
}

void Tip::add_press(const Field<float>& master) {
  Press press;
  double sum = 0;
  for (int y = 0; y < kMasterSize; ++y)
    for (int x = 0; x < kMasterSize; ++x) sum += static_cast<double>(master(x, y));
  press.mean = static_cast<float>(sum / (kMasterSize * kMasterSize));
  for (const int size : {256, 181, 128, 91, 64, 45, 32, 23, 16, 11, 8, 6, 4, 3, 2})
    press.maps.emplace_back(resample_area(master, size, size));
  presses_.push_back(std::move(press));
}

void Tip::find_extent(const Field<float>& widest) {
  extent_ = {0, 0};
  const auto outer_edge = [](int texel) {
    const float a = std::abs(2 * static_cast<float>(texel) / kMasterSize - 1);
    const float b = std::abs(2 * static_cast<float>(texel + 1) / kMasterSize - 1);
    return std::max(a, b);
  };
  for (int y = 0; y < kMasterSize; ++y) {
    for (int x = 0; x < kMasterSize; ++x) {
      if (!(widest(x, y) > 0)) continue;
      extent_.u = std::max(extent_.u, outer_edge(x));
      extent_.v = std::max(extent_.v, outer_edge(y));
    }
  }
}

void Tip::fill_tables(const BrushDefinition& brush, std::uint64_t seed) {
  for (int i = 0; i <= BristleTable::kSteps; ++i)
    grip_[i] = bristle_grip(brush, 2 * BristleTable::at_step(i), seed);
  if (!has_bristles(brush)) return;
  for (int d = 0; d < kDrynesses; ++d) {
    BristleTable table;
    const float density = kWetFrac * static_cast<float>(d) / (kDrynesses - 1);
    for (int i = 0; i <= BristleTable::kSteps; ++i)
      table[i] = bristle_supply(2 * BristleTable::at_step(i), density, seed);
    supply_.push_back(table);
  }
}

void Tip::fill_ends(const Field<float>& widest) {
  std::array<float, kMasterSize> most{};
  for (int y = 0; y < kMasterSize; ++y)
    for (const float value : widest.view().row_span(y))
      most[static_cast<std::size_t>(y)] = std::max(most[static_cast<std::size_t>(y)], value);
  for (int i = 0; i <= BristleTable::kSteps; ++i) {
    const float row = (BristleTable::at_step(i) + 0.5f) * kMasterSize - 0.5f;
    const float at = std::clamp(row, 0.0f, kMasterSize - 1.001f);
    const std::size_t low = static_cast<std::size_t>(at);
    const float value = most[low] + (at - static_cast<float>(low)) * (most[low + 1] - most[low]);
    ends_[i] = std::clamp((value - kEndsFrom) * kEndsPerValue, 0.0f, 1.0f);
    kept_[i] = 1 - share_over(kScraped, 1 - static_cast<double>(ends_[i]));
    reach_[i] = std::min(1.0f, value * kReachPerValue);
  }
  reach_[0] = reach_[BristleTable::kSteps] = 0;  // beyond the tip there is nothing
}

void Tip::list_texels(const Field<float>& map) {
  constexpr int kColumns = kReservoirColumns, kRows = kReservoirRows;
  const auto centre = [](int i, int n) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
  };
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      float value = 0;
      for (int j = std::max(0, y - 1); j <= std::min(kRows - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(kColumns - 1, x + 1); ++i)
          value = std::max(value, map(i, j));
      if (!(value > 0)) continue;
      const int index = y * kColumns + x;
      texels_.push_back(
          {index, centre(x, kColumns), centre(y, kRows), std::min(1.0f, value / mean())});
      covered_.add(x, y);
    }
  }
}

float Tip::mean(float press) const {
  const TexelPlace at(press, presses_.size());
  const float low = presses_[at.low].mean;
  return low + at.frac * (presses_[at.high].mean - low);
}

TipLevel Tip::level_for(float cell_frac, const TipState& state) const {
  // Half-octave steps: the next coarser map is nearer once a texel is 2^(1/4) too fine.
  constexpr float kHalfStep = 1.18920712f;
  const TexelPlace at(state.press, presses_.size());
  const std::vector<TipMap>& maps = presses_[at.low].maps;
  std::size_t size = 0;
  while (size + 1 < maps.size() && cell_frac * static_cast<float>(maps[size].size()) > kHalfStep)
    ++size;
  TipLevel level;
  level.low = &maps[size];
  level.high = &presses_[at.high].maps[size];
  level.frac = at.frac;
  if (state.density_frac >= kWetFrac || supply_.empty()) return level;
  const TexelPlace dry(state.density_frac / kWetFrac, supply_.size());
  level.supply_low = &supply_[dry.low];
  level.supply_high = &supply_[dry.high];
  level.supply_frac = dry.frac;
  return level;
}

}  // namespace pentimento
