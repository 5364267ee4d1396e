#include "core/detail/stamp/stamp_rows.h"

#include <algorithm>
#include <cstring>

#include "core/base/kernel.h"
#include "core/detail/store/open_cells.h"

namespace pentimento {

namespace {
static_assert(kSampledCells == kPacketCells);  // component after component of a packet

/// The results of measure_row().
struct MeasuredRow {
  float *hold, *pick_up_weight, *share;
};

PENTIMENTO_KERNEL
void measure_row(const StampPlan& given, const float* grip, int n, const float* value,
                 const float* base, const float* depth, const MeasuredRow& out) {
  const StampPlan plan = given;  // nobody else's: what is stored below does not change it
  float* __restrict hold = out.hold;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) hold[i] = stamp_hold(plan, value[i], grip[i]);
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i)
    share[i] = plan.share_scale * stamp_levelled(plan, value[i], 0.0f, base[i], depth[i]);
}

/// For a blade, after measure_row(): corrects the values under its ends. `from`: the index, along
/// `tip`, of the first cell.
PENTIMENTO_KERNEL
void measure_blade(const StampPlan& given, const BladeEnds& ends, const TipRow& tip, int from,
                   int n, const float* value, const float* base, const float* depth,
                   const MeasuredRow& out) {
  const StampPlan plan = given;
  const float v0 = tip.v0, dv = tip.dv;
  const float* hold = out.hold;
  float* __restrict pick_up_weight = out.pick_up_weight;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float v = v0 + dv * static_cast<float>(from + i);
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

/// PaintLoad::volume_of(), the same sum, of paint whose components lie apart.
PENTIMENTO_KERNEL
void find_volumes(const float* weight, int components, const float* paint, int n,
                  float* __restrict volume) {
  PacketValues lane[4];
  for (PacketValues& values : lane) std::fill_n(values.begin(), n, 0.0f);
  for (int k = 0; k < components; ++k, paint += kPacketCells) {
    float* sum = lane[k % 4].data();
    for (int i = 0; i < n; ++i) sum[i] += weight[k] * paint[i];
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    volume[i] = (lane[0][i] + lane[1][i]) + (lane[2][i] + lane[3][i]);
}
}  // namespace

StampRows::StampRows(DetailCanvas& canvas, std::span<const float> amount)
    : canvas_(canvas), fine_(canvas.layout().fine()), all_amounts_(amount.begin(), amount.end()) {
  row_value_.resize(at(canvas.layout().side() + kVectorCells));
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
  // Of a plane in which nothing lies, no stamp has to look at the cells.
  const int side = canvas_.layout().side();
  std::vector<float*> rows = planes_;
  for (float*& plane : rows) plane += static_cast<std::ptrdiff_t>(y0_ % side) * side;
  layers_.begin_rows(rows, (y1_ - y0_) * side);
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
  const CellRange touched = find_touched(stamp, y);
  for (int x = touched.begin; x < touched.end; x += kPacketCells)
    do_packet(stamp, y,
              packet_at(x, std::min(kPacketCells, touched.end - x), canvas_.layout().side()),
              touched.begin);
}

/// Finds the cells of a row where the tip's value is not 0, and their values.
StampRows::CellRange StampRows::find_touched(const QueuedStamp& stamp, int y) {
  const FootprintBox& box = stamp.cells();
  const int from_box = x0_ - box.x;
  const TipFootprint::CellSpan span = stamp.touched_cells(y);
  CellRange touched{std::max(span.begin - from_box, 0), std::min(span.end - from_box, x1_ - x0_)};
  if (touched.empty()) return {};
  const TipRow tip = tip_row(stamp.plan().pose, box, fine_, y);
  // Whole vectors: what they hold beyond the span is not looked at.
  const std::size_t vectors = (touched.count() + kVectorCells - 1) / kVectorCells;
  stamp.tip().row(tip, from_box + touched.begin, {row_value_.data(), vectors * kVectorCells});
  const float* value = row_value_.data();
  std::size_t skipped = 0, count = touched.count();
  while (skipped < count && !(value[skipped] > 0)) ++skipped;
  while (count > skipped && !(value[count - 1] > 0)) --count;
  std::copy(value + skipped, value + count, row_value_.begin());
  return {touched.begin + static_cast<int>(skipped), touched.begin + static_cast<int>(count)};
}

/// Does the stamp in a packet of a row whose first touched cell is `touched`.
void StampRows::do_packet(const QueuedStamp& stamp, int y, const StampPacket& packet, int touched) {
  const LayerRow cells = row(y, packet.first);
  float* depth_m = tile_->depth_m.data() + cells.offset;
  measure(stamp, y, packet, touched);
  const PacketValues& weight = stamp.plan().scrape_frac > 0 ? pick_up_weight_ : hold_;
  layers_.begin(cells, packet);
  layers_.pick_up(stamp.plan().pick_up, weight.data(), depth_m);
  if (!stamp.deposits()) return;
  lay(stamp, y, packet, depth_m);
  layers_.mix(stamp.plan().mix, hold_.data());
}

/// Finds the tip's value, its hold and the levelled share of each cell, before any paint is picked
/// up.
void StampRows::measure(const QueuedStamp& stamp, int y, const StampPacket& packet, int touched) {
  const float* value = row_value_.data() + (packet.first + packet.begin - touched);
  std::fill_n(value_.begin(), packet.size(), 0.0f);
  std::copy_n(value, packet.own(), value_.begin() + packet.begin);
  const FootprintBox& box = stamp.cells();
  const TipRow tip = tip_row(stamp.plan().pose, box, fine_, y);
  const int first = x0_ - box.x + touched;
  const TipRow part = {tip.u(first), tip.v(first), tip.du, tip.dv};
  const MeasuredRow out = {hold_.data(), pick_up_weight_.data(), share_.data()};
  const std::ptrdiff_t cell = row(y, packet.first).offset;
  const float *base = tile_->base_m.data() + cell, *depth = tile_->depth_m.data() + cell;
  const int from = packet.first - touched;
  PacketValues grip;
  stamp.grip().row(part.v0, part.dv, from, packet.cells, grip.data());
  measure_row(stamp.plan(), grip.data(), packet.cells, value_.data(), base, depth, out);
  if (stamp.plan().scrape_frac > 0)
    measure_blade(stamp.plan(), stamp.ends(), part, from, packet.cells, value_.data(), base, depth,
                  out);
}

/// Lays the paint that each cell gets. `depth_m`: from the packet's first cell on.
void StampRows::lay(const QueuedStamp& stamp, int y, const StampPacket& packet, float* depth_m) {
  if (!find_targets(stamp, y, packet)) return;
  open_cells(y, packet);
  const StampPlan& plan = stamp.plan();
  const TipRow tip = tip_row(plan.pose, stamp.cells(), fine_, y);
  paint_.resize(at(plan.stride) * kPacketCells);
  plan.reservoir->sample_planes(tip, x0_ - stamp.cells().x + packet.first, packet.cells,
                                paint_.data());
  find_volumes(plan.load->weight.data(), plan.stride, paint_.data(), packet.cells, volume_.data());
  if (!find_parts(plan, packet.cells,
                  {value_.data(), laid_share_.data(), volume_.data(), paint_.data()}, depth_m,
                  part_.data()))
    return;
  channel_paint_.clear();
  for (const int c : *channels_) channel_paint_.push_back(paint_.data() + at(1 + c) * kPacketCells);
  layers_.lay(target_.data(), part_.data(), channel_paint_);
}

/// Finds the layer that gets paint in each cell, and the share of the cells that have one. False if
/// none has.
bool StampRows::find_targets(const QueuedStamp& stamp, int y, const StampPacket& packet) {
  const int k = canvas_.layout().factor();
  const std::span<const BlockLayers> layers = stamp.layers_in(y / k);
  target_.fill(-1);
  std::fill_n(laid_share_.begin(), packet.size(), 0.0f);
  bool any = false;
  for (int i = packet.begin; i < packet.end;) {
    const int x = x0_ + packet.first + i;
    const int end = std::min(packet.end, i + (x / k + 1) * k - x);
    const std::int8_t target = layers[at(x / k - stamp.blocks().x0)].target;
    if (target >= 0) {
      std::fill(target_.begin() + i, target_.begin() + end, target);
      std::copy(share_.begin() + i, share_.begin() + end, laid_share_.begin() + i);
      any = true;
    }
    i = end;
  }
  return any;
}

/// Opens the layers that the guide opened, in the cells that get paint.
void StampRows::open_cells(int y, const StampPacket& packet) {
  if (tile_->open.empty()) return;
  const DetailLayout& layout = canvas_.layout();
  std::uint8_t* opened =
      tile_->open.opened.data() + at(y) % at(layout.side()) * at(layout.side()) + at(packet.first);
  if (std::memchr(opened + packet.begin, 0, at(packet.own())) == nullptr) return;
  const int k = layout.factor();
  PacketValues opens;
  for (int i = packet.begin; i < packet.end;) {
    const int x = x0_ + packet.first + i;
    const int end = std::min(packet.end, i + (x / k + 1) * k - x);
    opens.fill(0);
    bool any = false;
    for (; i < end; ++i) {
      if (opened[i] != 0 || !(laid_share_[at(i)] > 0)) continue;
      opened[i] = 1;
      opens[at(i)] = 1;
      any = true;
    }
    if (any) layers_.open(opening_in(*tile_, layout, x / k, y / k), opens.data());
  }
}

}  // namespace pentimento
