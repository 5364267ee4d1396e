#include "core/detail/stamp/stamp_rows.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/detail/store/open_cells.h"

namespace pentimento {

namespace {
/// The results of measure_row().
struct MeasuredRow {
  float *hold, *pick_up_weight, *share;
};

PENTIMENTO_KERNEL
void measure_row(const StampPlan& given, const BristleTable& grip, const TipRow& tip, int n,
                 const float* value, const float* base, const float* depth,
                 const MeasuredRow& out) {
  const StampPlan plan = given;  // nobody else's: what is stored below does not change it
  const float v0 = tip.v0, dv = tip.dv;
  float* __restrict hold = out.hold;
  float* __restrict share = out.share;
  // Two loops: the second is one of vectors, which the table keeps the first from being.
  for (int i = 0; i < n; ++i)
    hold[i] = stamp_hold(plan, grip, value[i], v0 + dv * static_cast<float>(i));
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i)
    share[i] = plan.share_scale * stamp_levelled(plan, value[i], 0.0f, base[i], depth[i]);
}

/// For a blade, after measure_row(): corrects the values under its ends.
PENTIMENTO_KERNEL
void measure_blade(const StampPlan& given, const BladeEnds& ends, const TipRow& tip, int n,
                   const float* value, const float* base, const float* depth,
                   const MeasuredRow& out) {
  const StampPlan plan = given;
  const float v0 = tip.v0, dv = tip.dv;
  const float* hold = out.hold;
  float* __restrict pick_up_weight = out.pick_up_weight;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float v = v0 + dv * static_cast<float>(i);
    share[i] =
        plan.share_scale * stamp_levelled(plan, value[i], ends.open.at(v), base[i], depth[i]);
    pick_up_weight[i] =
        stamp_pick_up_weight(plan, hold[i], ends.takes.at(v), {depth[i], base[i] + depth[i]});
  }
}

/// The input of find_parts(): of the tip, and of the reservoir's paint.
struct BrushedRow {
  const float *value, *share, *volume, *height;
};

/// Finds the part of the reservoir's paint that each cell gets, as far as there is room, and adds
/// its depth. False if the tip deposits nothing.
PENTIMENTO_KERNEL
bool find_parts(const StampPlan& given, int n, const BrushedRow& brushed, float* __restrict depth,
                float* __restrict out) {
  const StampPlan plan = given;
  const float *value = brushed.value, *share = brushed.share;
  const float *volume = brushed.volume, *height = brushed.height;
  int any = 0;  // not a bool, which keeps the loop from being a vector's
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float wanted = stamp_deposited(plan, volume[i], value[i], share[i]).part;
    const float room_m = std::max(0.0f, plan.deposit.max_depth_m - depth[i]);
    const float part = height[i] * wanted > room_m ? room_m / height[i] : wanted;
    const float deposited = share[i] > 0 ? part : 0.0f;
    depth[i] += deposited * height[i];
    out[i] = deposited;
    any |= share[i] > 0 ? 1 : 0;
  }
  return any != 0;
}

/// plane += part * paint of one component, `stride` floats from cell to cell.
PENTIMENTO_KERNEL
void add_paint(const float* part, const float* paint, int stride, int n, float* __restrict plane) {
  for (int i = 0; i < n; ++i) plane[i] += part[i] * paint[static_cast<std::ptrdiff_t>(i) * stride];
}
}  // namespace

StampRows::StampRows(DetailCanvas& canvas, std::span<const float> amount)
    : canvas_(canvas), fine_(canvas.layout().fine()), all_amounts_(amount.begin(), amount.end()) {
  for (std::vector<float>* v :
       {&value_, &share_, &hold_, &pick_up_weight_, &part_, &volume_, &height_})
    v->resize(at(canvas.layout().side()));
}

void StampRows::begin(int tile, const std::vector<int>& channels, int y0, int y1) {
  const int k = canvas_.layout().factor();
  tile_ = canvas_.find(tile);
  x0_ = tile_->box.x0 * k;
  x1_ = tile_->box.x1 * k;
  y0_ = y0 * k;
  y1_ = y1 * k;
  channels_ = &channels;
  amount_.clear();
  planes_.clear();
  for (const int c : channels) amount_.push_back(all_amounts_[at(c)]);
  for (int layer = 0; layer < canvas_.layers(); ++layer)
    for (const int c : channels)
      planes_.push_back(tile_->pigment[at(layer * canvas_.channels() + c)].data());
}

/// Row y of the canvas from the tile's cell `begin` on.
LayerRow StampRows::row(int y, int begin) const {
  const int side = canvas_.layout().side();
  return {planes_, static_cast<std::ptrdiff_t>(y % side) * side + begin, canvas_.layers(),
          static_cast<int>(channels_->size()), amount_};
}

void StampRows::apply(const QueuedStamp& stamp) {
  const FootprintBox& cells = stamp.cells();
  const int k = canvas_.layout().factor();
  const int y0 = std::max(y0_, cells.y), y1 = std::min(y1_, cells.y + cells.height);
  for (int y = y0; y < y1; ++y) {
    if (stamp.deposits() && (y == y0 || y % k == 0)) open_blocks(stamp, y / k);
    do_row(stamp, y);
  }
}

/// In blocks where the guide has just opened a layer, every fine cell waits until the tip touches
/// it.
void StampRows::open_blocks(const QueuedStamp& stamp, int block_y) {
  const CellBox& blocks = stamp.blocks();
  const std::span<const BlockLayers> layers = stamp.layers_in(block_y);
  const int first = std::max(blocks.x0, tile_->box.x0), last = std::min(blocks.x1, tile_->box.x1);
  for (int x = first; x < last; ++x) {
    const BlockLayers& block = layers[at(x - blocks.x0)];
    if (block.opens)
      await_tip(*tile_, canvas_.layout(), x, block_y, canvas_.layers(), block.opening);
  }
}

void StampRows::do_row(const QueuedStamp& stamp, int y) {
  const CellRange touched = measure(stamp, y);
  if (touched.empty()) return;
  const int side = canvas_.layout().side();
  const LayerRow cells = row(y, touched.begin);
  const std::vector<float>& weight = stamp.plan().scrape_frac > 0 ? pick_up_weight_ : hold_;
  pick_up_row(stamp.plan().pick_up, cells, {weight.data(), touched.count()},
              tile_->depth_m.data() + static_cast<std::ptrdiff_t>(y % side) * side + touched.begin);
  if (!stamp.deposits()) return;
  deposit(stamp, y, touched);
  mix_layers_row(stamp.plan().mix, cells, {hold_.data(), touched.count()});
}

/// Finds the tip's value, its hold and the levelled share of each touched cell, before any paint is
/// picked up.
StampRows::CellRange StampRows::measure(const QueuedStamp& stamp, int y) {
  const FootprintBox& box = stamp.cells();
  const int side = canvas_.layout().side();
  CellRange touched{std::max(box.x, x0_) - x0_, std::min(box.x + box.width, x1_) - x0_};
  if (touched.empty()) return touched;
  const TipRow tip = tip_row(stamp.plan().pose, box, fine_, y);
  const int from_box = x0_ - box.x;
  const TipFootprint::CellSpan touched_span =
      stamp.tip().touched_span(tip, from_box + touched.begin, from_box + touched.end);
  touched = {touched_span.begin - from_box, touched_span.end - from_box};
  if (touched.empty()) return touched;
  stamp.tip().row(tip, from_box + touched.begin, {value_.data(), touched.count()});
  const float* value = value_.data();
  std::size_t skipped = 0, count = touched.count();
  while (skipped < count && !(value[skipped] > 0)) ++skipped;
  while (count > skipped && !(value[count - 1] > 0)) --count;
  touched.end = touched.begin + static_cast<int>(count);
  touched.begin += static_cast<int>(skipped);
  if (touched.empty()) return touched;
  std::copy(value + skipped, value + count, value_.begin());
  const std::ptrdiff_t cell = static_cast<std::ptrdiff_t>(y % side) * side + touched.begin;
  const TipRow part = {tip.u(from_box + touched.begin), tip.v(from_box + touched.begin), tip.du,
                       tip.dv};
  const MeasuredRow out = {hold_.data(), pick_up_weight_.data(), share_.data()};
  const float *base = tile_->base_m.data() + cell, *depth = tile_->depth_m.data() + cell;
  const int n = static_cast<int>(touched.count());
  measure_row(stamp.plan(), stamp.grip(), part, n, value_.data(), base, depth, out);
  if (stamp.plan().scrape_frac > 0)
    measure_blade(stamp.plan(), stamp.ends(), part, n, value_.data(), base, depth, out);
  return touched;
}

/// Finds the paint that each cell gets, as `part_` of `paint_`, and its depth. False if no cell
/// gets any.
bool StampRows::sample(const QueuedStamp& stamp, int y, const CellRange& cells, float* depth) {
  const int k = canvas_.layout().factor();
  const std::span<const BlockLayers> layers = stamp.layers_in(y / k);
  const auto is_laid_in = [&](int x) {
    return layers[at((x0_ + x) / k - stamp.blocks().x0)].target >= 0;
  };
  const auto next_block = [&](int x) { return std::min(cells.end, ((x0_ + x) / k + 1) * k - x0_); };
  paint_.resize(at(canvas_.layout().side()) * at(stamp.plan().stride));
  std::fill_n(part_.begin(), cells.count(), 0.0f);
  bool any = false;
  for (int x = cells.begin; x < cells.end;) {
    int end = next_block(x);
    if (is_laid_in(x)) {
      while (end < cells.end && is_laid_in(end)) end = next_block(end);
      any |= sample_run(stamp, y, {x, end}, cells.begin, depth + (x - cells.begin));
    }
    x = end;
  }
  return any;
}

/// The same for cells in blocks side by side. `first`: the cell with which the rows begin.
bool StampRows::sample_run(const QueuedStamp& stamp, int y, const CellRange& run, int first,
                           float* depth) {
  const StampPlan& plan = stamp.plan();
  const TipRow tip = tip_row(plan.pose, stamp.cells(), fine_, y);
  open_cells(y, run, first);
  const std::size_t from = at(run.begin - first);
  float* paint = paint_.data() + from * at(plan.stride);
  plan.reservoir->sample_row(tip, x0_ - stamp.cells().x + run.begin, static_cast<int>(run.count()),
                             paint);
  for (std::size_t i = from; i < from + run.count(); ++i, paint += plan.stride) {
    volume_[i] = plan.load->volume_of(paint);
    height_[i] = *paint;
  }
  return find_parts(plan, static_cast<int>(run.count()),
                    {&value_[from], &share_[from], &volume_[from], &height_[from]}, depth,
                    &part_[from]);
}

/// Opens the layers that the guide opened, in the cells that get paint. `first`: the cell with
/// which the row of shares begins.
void StampRows::open_cells(int y, const CellRange& cells, int first) {
  if (tile_->open.empty()) return;
  const std::size_t side = at(canvas_.layout().side());
  const LayerRow whole = row(y, 0);
  const std::uint8_t* opened = tile_->open.opened.data() + at(y) % side * side;
  for (int x = cells.begin; x < cells.end; ++x)
    if (opened[x] == 0 && share_[at(x - first)] > 0)
      open_cell(*tile_, canvas_.layout(), whole, x0_ + x, y, x);
}

void StampRows::deposit(const QueuedStamp& stamp, int y, const CellRange& touched) {
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.side(), k = layout.factor(), stride = stamp.plan().stride;
  float* depth =
      tile_->depth_m.data() + static_cast<std::ptrdiff_t>(y % side) * side + touched.begin;
  if (!sample(stamp, y, touched, depth)) return;
  const LayerRow cells = row(y, 0);
  const std::span<const BlockLayers> layers = stamp.layers_in(y / k);
  const auto target_at = [&](int x) {
    return layers[at((x0_ + x) / k - stamp.blocks().x0)].target;
  };
  const auto next_block = [&](int x) {
    return std::min(touched.end, ((x0_ + x) / k + 1) * k - x0_);
  };
  for (int x = touched.begin; x < touched.end;) {
    // Cells of blocks side by side that get the paint in the same layer.
    const int target = target_at(x);
    int end = next_block(x);
    while (end < touched.end && target_at(end) == target) end = next_block(end);
    const std::size_t first = at(x - touched.begin);
    for (std::size_t c = 0; target >= 0 && c < channels_->size(); ++c)
      add_paint(part_.data() + first, paint_.data() + first * at(stride) + 1 + at((*channels_)[c]),
                stride, end - x, &cells.at(target, static_cast<int>(c), x));
    x = end;
  }
}

}  // namespace pentimento
