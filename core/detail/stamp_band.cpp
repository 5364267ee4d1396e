#include "core/detail/stamp_band.h"

#include <algorithm>

#include "core/detail/open_cells.h"
#include "core/fluid/conservative/kernel.h"

namespace pentimento {

namespace {
/// What measure_row() finds.
struct MeasuredRow {
  float *touch, *grasp, *share;
};

PENTIMENTO_KERNEL
void measure_row(const StampPlan& given, const HairTable& grip, const TipRow& tip, int n,
                 const float* value, const float* base, const float* depth,
                 const MeasuredRow& out) {
  const StampPlan plan = given;  // nobody else's: what is stored below does not change it
  const float v0 = tip.v0, dv = tip.dv;
  float* __restrict touch = out.touch;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    touch[i] = stamp_touch(plan, grip, value[i], v0 + dv * static_cast<float>(i));
    share[i] = plan.share_scale * stamp_levelled(plan, value[i], 0.0f, base[i] + depth[i]);
  }
}

/// Of a blade, after measure_row(): what its ends do otherwise.
PENTIMENTO_KERNEL
void measure_blade(const StampPlan& given, const HairTable& ends, const TipRow& tip, int n,
                   const float* value, const float* base, const float* depth,
                   const MeasuredRow& out) {
  const StampPlan plan = given;
  const float v0 = tip.v0, dv = tip.dv;
  const float* touch = out.touch;
  float* __restrict grasp = out.grasp;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float end = ends.at(v0 + dv * static_cast<float>(i)), height = base[i] + depth[i];
    share[i] = plan.share_scale * stamp_levelled(plan, value[i], end, height);
    grasp[i] = stamp_lift_weight(plan, touch[i], end, {depth[i], height});
  }
}

/// plane += part * paint of one component, `stride` floats from cell to cell.
PENTIMENTO_KERNEL
void add_paint(const float* part, const float* paint, int stride, int n, float* __restrict plane) {
  for (int i = 0; i < n; ++i) plane[i] += part[i] * paint[static_cast<std::ptrdiff_t>(i) * stride];
}
}  // namespace

StampBand::StampBand(DetailCanvas& canvas, std::span<const float> amount)
    : canvas_(canvas), fine_(canvas.layout().fine()), all_amounts_(amount.begin(), amount.end()) {
  for (std::vector<float>* v : {&value_, &share_, &touch_, &grasp_, &part_})
    v->resize(at(canvas.layout().side()));
}

void StampBand::begin(int tile, const std::vector<int>& channels, int y0, int y1) {
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
LayerRow StampBand::row(int y, int begin) const {
  const int side = canvas_.layout().side();
  return {planes_, static_cast<std::ptrdiff_t>(y % side) * side + begin, canvas_.layers(),
          static_cast<int>(channels_->size()), amount_};
}

void StampBand::apply(const QueuedStamp& stamp) {
  const CellBox& cells = stamp.cells();
  const int k = canvas_.layout().factor();
  const int y0 = std::max(y0_, cells.y), y1 = std::min(y1_, cells.y + cells.height);
  for (int y = y0; y < y1; ++y) {
    if (stamp.lays() && (y == y0 || y % k == 0)) open_blocks(stamp, y / k);
    do_row(stamp, y);
  }
}

/// In blocks that the guide has just opened every cell waits to be touched.
void StampBand::open_blocks(const QueuedStamp& stamp, int block_y) {
  const GuideBox& blocks = stamp.blocks();
  const std::span<const BlockLayers> layers = stamp.layers_in(block_y);
  const int first = std::max(blocks.x0, tile_->box.x0), last = std::min(blocks.x1, tile_->box.x1);
  for (int x = first; x < last; ++x) {
    const BlockLayers& block = layers[at(x - blocks.x0)];
    if (block.opens)
      await_touch(*tile_, canvas_.layout(), x, block_y, canvas_.layers(), block.opening);
  }
}

void StampBand::do_row(const QueuedStamp& stamp, int y) {
  const Cells touched = measure(stamp, y);
  if (touched.empty()) return;
  const int side = canvas_.layout().side();
  const LayerRow cells = row(y, touched.begin);
  const std::vector<float>& hold = stamp.plan().scrape_frac > 0 ? grasp_ : touch_;
  lift_row(stamp.plan().lift, cells, {hold.data(), touched.count()},
           tile_->depth_m.data() + static_cast<std::ptrdiff_t>(y % side) * side + touched.begin);
  if (!stamp.lays()) return;
  lay(stamp, y, touched);
  mix_layers_row(stamp.plan().mix, cells, {touch_.data(), touched.count()});
}

/// The tip's value, its hold and the levelled share of each touched cell, before anything is
/// lifted.
StampBand::Cells StampBand::measure(const QueuedStamp& stamp, int y) {
  const CellBox& box = stamp.cells();
  const int side = canvas_.layout().side();
  Cells touched{std::max(box.x, x0_) - x0_, std::min(box.x + box.width, x1_) - x0_};
  if (touched.empty()) return touched;
  const TipRow tip = tip_row(stamp.plan().pose, box, fine_, y);
  const int from_box = x0_ - box.x;
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
  const MeasuredRow out = {touch_.data(), grasp_.data(), share_.data()};
  const float *base = tile_->base_m.data() + cell, *depth = tile_->depth_m.data() + cell;
  const int n = static_cast<int>(touched.count());
  measure_row(stamp.plan(), stamp.grip(), part, n, value_.data(), base, depth, out);
  if (stamp.plan().scrape_frac > 0)
    measure_blade(stamp.plan(), stamp.ends(), part, n, value_.data(), base, depth, out);
  return touched;
}

/// The paint that comes to each cell, as `part_` of `paint_`, and its depth. False if none comes.
bool StampBand::sample(const QueuedStamp& stamp, int y, const Cells& cells, float* depth) {
  const int k = canvas_.layout().factor();
  const std::span<const BlockLayers> layers = stamp.layers_in(y / k);
  paint_.resize(at(canvas_.layout().side()) * at(stamp.plan().stride));
  std::fill_n(part_.begin(), cells.count(), 0.0f);
  bool any = false;
  for (int x = cells.begin; x < cells.end;) {
    const int block = (x0_ + x) / k, end = std::min(cells.end, (block + 1) * k - x0_);
    if (layers[at(block - stamp.blocks().x0)].target >= 0)
      any |= sample_cells(stamp, y, {x, end}, cells.begin, depth);
    x = end;
  }
  return any;
}

/// Those of one block. `first`: the cell that the rows of values and `depth` begin with.
bool StampBand::sample_cells(const QueuedStamp& stamp, int y, const Cells& cells, int first,
                             float* depth) {
  const StampPlan& plan = stamp.plan();
  const int side = canvas_.layout().side(), from_box = x0_ - stamp.cells().x;
  const TipRow tip = tip_row(plan.pose, stamp.cells(), fine_, y);
  const LayerRow whole = row(y, 0);
  const std::uint8_t* opened =
      tile_->open.empty() ? nullptr : tile_->open.opened.data() + at(y % side) * at(side);
  bool any = false;
  for (int x = cells.begin; x < cells.end; ++x) {
    const std::size_t i = at(x - first);
    if (!(share_[i] > 0)) continue;
    if (opened != nullptr && opened[x] == 0)
      open_cell(*tile_, canvas_.layout(), whole, x0_ + x, y, x);
    float* paint = paint_.data() + i * at(plan.stride);
    plan.reservoir->sample(tip.u(from_box + x), tip.v(from_box + x), paint);
    float part = stamp_laid(plan, paint, value_[i], share_[i]).part;
    const float room_m = std::max(0.0f, plan.lay.max_depth_m - depth[i]);
    if (paint[0] * part > room_m) part = room_m / paint[0];
    depth[i] += part * paint[0];
    part_[i] = part;
    any = true;
  }
  return any;
}

void StampBand::lay(const QueuedStamp& stamp, int y, const Cells& touched) {
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.side(), k = layout.factor(), stride = stamp.plan().stride;
  float* depth =
      tile_->depth_m.data() + static_cast<std::ptrdiff_t>(y % side) * side + touched.begin;
  if (!sample(stamp, y, touched, depth)) return;
  const LayerRow cells = row(y, 0);
  const std::span<const BlockLayers> layers = stamp.layers_in(y / k);
  for (int x = touched.begin; x < touched.end;) {
    const int block = (x0_ + x) / k, end = std::min(touched.end, (block + 1) * k - x0_);
    const int target = layers[at(block - stamp.blocks().x0)].target;
    const std::size_t first = at(x - touched.begin);
    for (std::size_t c = 0; target >= 0 && c < channels_->size(); ++c)
      add_paint(part_.data() + first, paint_.data() + first * at(stride) + 1 + at((*channels_)[c]),
                stride, end - x, &cells.at(target, static_cast<int>(c), x));
    x = end;
  }
}

}  // namespace pentimento
