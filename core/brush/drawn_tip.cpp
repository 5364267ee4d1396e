#include "core/brush/drawn_tip.h"

#include <algorithm>

#include "core/base/scratch.h"
#include "core/brush/edge_cells.h"

namespace pentimento {

void DrawnTip::draw(const StampPlan& plan, bool is_blade) {
  begin(plan, is_blade);
  for (int y = 0; y < box_.height; ++y) draw_row(y);
}

void DrawnTip::begin(const StampPlan& plan, bool is_blade) {
  stamp_ = plan.stamp;
  tip_ = plan.tip;
  state_ = plan.state;
  pose_ = plan.pose;
  box_ = plan.box;
  footprint_.draw_cells(plan, cell_size_m(grid_));
  passed_ = passed_shares(plan, grid_);
  if (is_blade) ends_ = blade_ends(*plan.tip, plan.pose, grid_);
  grow(value_, static_cast<std::size_t>(box_.width) * static_cast<std::size_t>(box_.height));
  grow(row_, static_cast<std::size_t>(box_.height));
}

void DrawnTip::draw_row(int y) {
  DrawnTipRow& row = row_[static_cast<std::size_t>(y)];
  row.place = tip_row(pose_, box_, grid_, box_.y + y);
  row.span = footprint_.touched_span(row.place, 0, box_.width);
  float* value = value_.data() + static_cast<std::ptrdiff_t>(y) * box_.width;
  footprint_.row(row.place, row.span.begin,
                 {value + row.span.begin, static_cast<std::size_t>(row.span.end - row.span.begin)});
  row.value = value;
  TouchedCells touched{row.span.begin, row.span.end};
  while (touched.begin < touched.end && !(value[touched.begin] > 0)) ++touched.begin;
  while (touched.begin < touched.end && !(value[touched.end - 1] > 0)) --touched.end;
  row.touched = touched.count() > 0 ? touched : TouchedCells{};
}

bool DrawnTip::is_of(const StampPlan& plan) const {
  return tip_ != nullptr && tip_ == plan.tip && stamp_ == plan.stamp &&
         state_.press == plan.state.press && state_.density_frac == plan.state.density_frac;
}

}  // namespace pentimento
