#pragma once
// What the scheme reports of all its steps: maxima, and how much of the canvas was awake.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/runs.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"

namespace pentimento::conservative {

/// The largest |value| of a row of n values, or `highest` if that is larger.
float highest_row(const float* value, int n, float highest);

/// How far the fastest paint of these cells comes in a time of `dt_s`, in cells.
float travel_cells(const CanvasState& state, const std::vector<Run>& cells, float dt_s);

class StepReport {
 public:
  /// A step begins.
  void begin() { steps_ += 1; }
  /// What a step came to: its paint lies in these cells.
  void add(const CanvasState& state, const std::vector<Run>& cells, double awake_share,
           const Threads& threads);
  /// awake_share_mean, awake_share_max, max_speed_m_s, max_depth_m.
  std::vector<std::pair<std::string, double>> statistics() const;

  /// All of it as numbers, so that another report can go on with them.
  std::vector<double> numbers() const;
  static constexpr std::size_t kNumbers = 5;
  /// `numbers`: kNumbers of them, none negative.
  void set(std::span<const double> numbers);

 private:
  double steps_ = 0;
  double awake_share_sum_ = 0;
  double awake_share_max_ = 0;
  double speed_max_m_s_ = 0;
  double depth_max_m_ = 0;
};

}  // namespace pentimento::conservative
