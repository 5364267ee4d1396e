#include "core/detail/stamp/queued_stamp.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"

namespace pentimento {

namespace {
FootprintBox cells_of(const StampPlan& plan, const CanvasGeometry& fine, int factor) {
  FootprintBox box = box_of(plan.pose, plan.extent, fine);
  const int x1 = std::max(box.x + box.width, (plan.box.x + plan.box.width) * factor);
  const int y1 = std::max(box.y + box.height, (plan.box.y + plan.box.height) * factor);
  box.x = std::min(box.x, plan.box.x * factor);
  box.y = std::min(box.y, plan.box.y * factor);
  box.width = x1 - box.x;
  box.height = y1 - box.y;
  return box;
}

/// sum += share pigment
PENTIMENTO_KERNEL
void add_amount_row(float share, const float* pigment, int n, float* __restrict sum) {
  for (int i = 0; i < n; ++i) sum[i] += share * pigment[i];
}

/// The amount of pigment in each layer of a row of the guide's cells [x, x + n), layer after layer.
void find_totals(const CanvasState& guide, std::span<const float> amount, int x, int y, int n,
                 std::span<float> total) {
  std::fill(total.begin(), total.end(), 0.0f);
  for (int layer = 0; layer < guide.layers; ++layer) {
    float* sum = total.data() + static_cast<std::ptrdiff_t>(layer) * n;
    for (int c = 0; c < guide.channels; ++c) {
      const float share = amount[static_cast<std::size_t>(c)];
      const float* pigment = guide.channel(layer, c).row(y) + x;
      if (share != 0 && any_not_zero(pigment, n)) add_amount_row(share, pigment, n, sum);
    }
  }
}

/// `body` for each block, with its cell of the guide.
template <typename Body>
void for_blocks(const CellBox& blocks, std::vector<BlockLayers>& layers, const Body& body) {
  std::size_t i = 0;
  for (int y = blocks.y0; y < blocks.y1; ++y)
    for (int x = blocks.x0; x < blocks.x1; ++x) body(x, y, layers[i++]);
}
}  // namespace

void QueuedStamp::draw_tip(const StampPlan& plan, const DetailLayout& layout) {
  const CanvasGeometry fine = layout.fine();
  tip_.draw_swept(plan, std::sqrt(fine.dx_m() * fine.dy_m()));
}

void QueuedStamp::before_deposit(const StampPlan& plan, const CanvasState& guide,
                                 const DetailLayout& layout, std::span<const float> amount) {
  const CanvasGeometry fine = layout.fine();
  const int k = layout.factor();
  plan_ = plan;
  load_ = *plan.load;
  plan_.load = &load_;
  plan_.reservoir = nullptr;
  plan_.tip = nullptr;
  grip_ = plan.tip->grip_table();
  if (plan.scrape_frac > 0) ends_ = blade_ends(*plan.tip, plan.pose, fine);
  deposits_ = false;
  cells_ = cells_of(plan, fine, k);
  blocks_ = {cells_.x / k, (cells_.x + cells_.width + k - 1) / k, cells_.y / k,
             (cells_.y + cells_.height + k - 1) / k};
  layers_.assign(
      static_cast<std::size_t>(blocks_.width()) * static_cast<std::size_t>(blocks_.height()), {});
  const auto width = static_cast<std::size_t>(blocks_.width());
  std::vector<float> row(width * static_cast<std::size_t>(guide.layers));
  std::array<float, kMaxLayers> cell{};
  const std::span<const float> total(cell.data(), static_cast<std::size_t>(guide.layers));
  for_blocks(blocks_, layers_, [&](int x, int y, BlockLayers& block) {
    if (x == blocks_.x0) find_totals(guide, amount, x, y, blocks_.width(), row);
    for (std::size_t layer = 0; layer < total.size(); ++layer)
      cell[layer] = row[layer * width + static_cast<std::size_t>(x - blocks_.x0)];
    block.opens = guide.stroke(x, y) != plan.stroke_id;
    if (block.opens) {
      block.opening = opening_of(total);
      block.target = static_cast<std::int8_t>(block.opening.target);
    } else {
      block.target = static_cast<std::int8_t>(layer_on_top(total));
    }
  });
}

void QueuedStamp::after_deposit(const StampPlan& plan, const CanvasState& guide) {
  reservoir_ = *plan.reservoir;
  plan_.reservoir = &reservoir_;
  deposits_ = true;
  for_blocks(blocks_, layers_, [&](int x, int y, BlockLayers& block) {
    if (guide.stroke(x, y) == plan.stroke_id) return;
    block.opens = false;
    block.target = -1;
  });
}

void QueuedStamp::find_touched(const DetailLayout& layout) {
  const CanvasGeometry fine = layout.fine();
  touched_.clear();
  for (int y = cells_.y; y < cells_.y + cells_.height; ++y)
    touched_.push_back(tip_.touched_span(tip_row(plan_.pose, cells_, fine, y), 0, cells_.width));
}

QueuedStamp::BlockSpan QueuedStamp::touched_blocks(int y, const DetailLayout& layout) const {
  const int k = layout.factor();
  TipFootprint::CellSpan touched{cells_.width, 0};
  const int y0 = std::max(y * k, cells_.y), y1 = std::min((y + 1) * k, cells_.y + cells_.height);
  for (int row = y0; row < y1; ++row) {
    const TipFootprint::CellSpan here = touched_cells(row);
    if (here.end <= here.begin) continue;
    touched.begin = std::min(touched.begin, here.begin);
    touched.end = std::max(touched.end, here.end);
  }
  if (touched.end <= touched.begin) return {};
  return {(cells_.x + touched.begin) / k, (cells_.x + touched.end - 1) / k + 1};
}

bool QueuedStamp::opens_in(const CellBox& part) const {
  if (!deposits_) return false;
  const int x0 = std::max(part.x0, blocks_.x0), x1 = std::min(part.x1, blocks_.x1);
  for (int y = std::max(part.y0, blocks_.y0); y < std::min(part.y1, blocks_.y1); ++y)
    for (int x = x0; x < x1; ++x)
      if (layers_in(y)[static_cast<std::size_t>(x - blocks_.x0)].opens) return true;
  return false;
}

}  // namespace pentimento
