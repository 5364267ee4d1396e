#include "core/fluid/conservative/step_report.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/check.h"
#include "core/base/kernel.h"

namespace pentimento::conservative {

// Positive floats have the order of their bits, and a maximum of integers may be taken in any
// order, so the compiler takes many at a time.
PENTIMENTO_KERNEL
float highest_row(const float* value, int n, float highest) {
  std::int32_t most = std::bit_cast<std::int32_t>(highest);
  for (int i = 0; i < n; ++i) {
    const std::int32_t size = std::bit_cast<std::int32_t>(value[i]) & 0x7fffffff;
    most = size > most ? size : most;
  }
  return std::bit_cast<float>(most);
}

float travel_cells(const CanvasState& state, const std::vector<Run>& cells, float dt_s) {
  float x_m_s = 0, y_m_s = 0;
  for (const Run& r : cells) {
    x_m_s = highest_row(state.velocity_x_m_s.row(r.y) + r.x0, r.size(), x_m_s);
    y_m_s = highest_row(state.velocity_y_m_s.row(r.y) + r.x0, r.size(), y_m_s);
  }
  return dt_s * std::max(x_m_s / state.geometry.dx_m(), y_m_s / state.geometry.dy_m());
}

void StepReport::add(const CanvasState& state, const std::vector<Run>& cells, double awake_share,
                     const Threads& threads) {
  std::vector<float> speed(cells.size()), depth(cells.size());
  for_runs(threads, cells, [&](const Run& r) {
    const auto k = static_cast<std::size_t>(&r - cells.data());
    depth[k] = highest_row(state.depth_m.row(r.y) + r.x0, r.size(), 0);
    speed[k] = highest_row(state.velocity_x_m_s.row(r.y) + r.x0, r.size(), 0);
    speed[k] = highest_row(state.velocity_y_m_s.row(r.y) + r.x0, r.size(), speed[k]);
  });
  for (const float s : speed) speed_max_m_s_ = std::max(speed_max_m_s_, static_cast<double>(s));
  for (const float d : depth) depth_max_m_ = std::max(depth_max_m_, static_cast<double>(d));
  awake_share_sum_ += awake_share;
  awake_share_max_ = std::max(awake_share_max_, awake_share);
}

std::vector<std::pair<std::string, double>> StepReport::statistics() const {
  return {{"awake_share_mean", steps_ > 0 ? awake_share_sum_ / steps_ : 0},
          {"awake_share_max", awake_share_max_},
          {"max_speed_m_s", speed_max_m_s_},
          {"max_depth_m", depth_max_m_}};
}

std::vector<double> StepReport::numbers() const {
  return {steps_, awake_share_sum_, awake_share_max_, speed_max_m_s_, depth_max_m_};
}

void StepReport::set(std::span<const double> numbers) {
  PENTIMENTO_CHECK(numbers.size() == kNumbers);
  steps_ = numbers[0];
  awake_share_sum_ = numbers[1];
  awake_share_max_ = numbers[2];
  speed_max_m_s_ = numbers[3];
  depth_max_m_ = numbers[4];
}

}  // namespace pentimento::conservative
