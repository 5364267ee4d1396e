#include "core/detail/detail_stamp.h"

#include <algorithm>
#include <cmath>

#include "core/detail/open_cells.h"
#include "core/fluid/conservative/kernel.h"

namespace pentimento {

namespace {
constexpr std::int8_t kOpens = -1;  // a target that is known once the guide has laid

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The cells of the tip, and all of the blocks that the guide's stamp may touch.
CellBox cells_of(const StampPlan& plan, const CanvasGeometry& fine, int factor) {
  CellBox box = box_of(plan.pose, plan.extent, fine);
  const int x1 = std::max(box.x + box.width, (plan.box.x + plan.box.width) * factor);
  const int y1 = std::max(box.y + box.height, (plan.box.y + plan.box.height) * factor);
  box.x = std::min(box.x, plan.box.x * factor);
  box.y = std::min(box.y, plan.box.y * factor);
  box.width = x1 - box.x;
  box.height = y1 - box.y;
  return box;
}

/// The amount of pigment in each layer of a cell of the guide.
void find_totals(const CanvasState& guide, std::span<const float> amount, int x, int y,
                 std::span<float> total) {
  for (int layer = 0; layer < guide.layers; ++layer) {
    float sum = 0;
    for (int c = 0; c < guide.channels; ++c)
      if (amount[at(c)] != 0) sum += amount[at(c)] * guide.channel(layer, c)(x, y);
    total[at(layer)] = sum;
  }
}
/// What measure_row() finds.
struct MeasuredRow {
  float *touch, *grasp, *share;
};

PENTIMENTO_KERNEL
void measure_row(const StampPlan& given, const TipRow& tip, int n, const float* value,
                 const float* base, const float* depth, const MeasuredRow& out) {
  const StampPlan plan = given;  // nobody else's: what is stored below does not change it
  const float v0 = tip.v0, dv = tip.dv;
  float* __restrict touch = out.touch;
  float* __restrict grasp = out.grasp;
  float* __restrict share = out.share;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    touch[i] = stamp_touch(plan, value[i], v0 + dv * static_cast<float>(i));
    share[i] = plan.share_scale * stamp_levelled(plan, value[i], base[i] + depth[i]);
  }
  if (!(plan.scrape_frac > 0)) {
    std::copy_n(touch, n, grasp);
    return;
  }
  for (int i = 0; i < n; ++i)
    grasp[i] = stamp_lift_weight(plan, touch[i], value[i], {depth[i], base[i] + depth[i]});
}

/// The cells from the first to the last that the tip touches.
DetailStamp::Cells touched_cells(std::span<const float> value) {
  int begin = 0, end = static_cast<int>(value.size());
  while (begin < end && !(value[at(begin)] > 0)) ++begin;
  while (begin < end && !(value[at(end - 1)] > 0)) --end;
  return {begin, end};
}
}  // namespace

DetailStamp::DetailStamp(DetailCanvas& canvas, std::span<const float> amount,
                         const Threads& threads)
    : canvas_(canvas),
      fine_(canvas.layout().fine()),
      amount_(amount.begin(), amount.end()),
      threads_(threads) {}

/// Calls body(part) for the stamp's parts for which there was memory.
template <typename Body>
void DetailStamp::for_parts(const Body& body) {
  threads_.for_ranges(0, static_cast<int>(used_), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      if (parts_[at(i)].usable) body(parts_[at(i)]);
  });
}

void DetailStamp::lift(const StampPlan& plan, const CanvasState& guide) {
  find_parts(plan);
  for (std::size_t i = 0; i < used_; ++i) find_planes(parts_[i]);
  tip_.draw(plan, std::sqrt(fine_.dx_m() * fine_.dy_m()));
  for_parts([&](Part& part) {
    measure(plan, part);
    lift_part(plan, part);
    note_layers(plan, guide, part);
  });
}

void DetailStamp::lay(const StampPlan& plan, const CanvasState& guide) {
  const int k = canvas_.layout().factor();
  for (std::size_t i = 0; i < used_; ++i) {
    Part& part = parts_[i];
    canvas_.cover(part.tile, guide,
                  {part.x0 / k, (part.x1 + k - 1) / k, part.y0 / k, (part.y1 + k - 1) / k});
    find_planes(part);
  }
  for_parts([&](Part& part) {
    open_part(plan, guide, part);
    lay_part(plan, part);
  });
}

GuideBox DetailStamp::box() const {
  const int k = canvas_.layout().factor();
  return {box_.x / k, (box_.x + box_.width + k - 1) / k, box_.y / k,
          (box_.y + box_.height + k - 1) / k};
}

/// The tiles under the tip, with the cells of each.
void DetailStamp::find_parts(const StampPlan& plan) {
  box_ = cells_of(plan, fine_, canvas_.layout().factor());
  used_ = 0;
  if (box_.empty()) return;
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.side();
  for (int row = box_.y / side; row * side < box_.y + box_.height; ++row) {
    for (int column = box_.x / side; column * side < box_.x + box_.width; ++column) {
      if (used_ == parts_.size()) parts_.emplace_back();
      Part& part = parts_[used_++];
      part.tile = layout.tile_of(column, row);
      part.x0 = std::max(box_.x, column * side);
      part.x1 = std::min(box_.x + box_.width, (column + 1) * side);
      part.y0 = std::max(box_.y, row * side);
      part.y1 = std::min(box_.y + box_.height, (row + 1) * side);
    }
  }
}

void DetailStamp::find_planes(Part& part) {
  DetailTile& tile = canvas_.at(part.tile);
  part.usable = tile.base_m && (tile.depth_m || canvas_.make(tile.depth_m));
  part.channels = canvas_.complete_channels(part.tile);
  part.amount.clear();
  part.planes.clear();
  for (const int c : part.channels) part.amount.push_back(amount_[at(c)]);
  for (int layer = 0; layer < canvas_.layers(); ++layer)
    for (const int c : part.channels)
      part.planes.push_back(tile.pigment[at(layer * canvas_.channels() + c)].data());
}

/// The part's row y from its cell `begin` on.
LayerRow DetailStamp::row_of(const Part& part, int y, int begin) const {
  const int side = canvas_.layout().side();
  return {part.planes, static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side + begin,
          canvas_.layers(), static_cast<int>(part.channels.size()), part.amount};
}

/// The tip's value, its hold and the levelled share of each cell, before anything is lifted.
void DetailStamp::measure(const StampPlan& plan, Part& part) {
  const int side = canvas_.layout().side();
  const DetailTile& tile = *canvas_.find(part.tile);
  const std::size_t width = at(part.width());
  const std::size_t cells = width * at(part.y1 - part.y0);
  for (std::vector<float>* v : {&part.value, &part.share, &part.touch, &part.grasp})
    if (v->size() < cells) v->resize(cells);
  part.touched.resize(at(part.y1 - part.y0));
  for (int y = part.y0; y < part.y1; ++y) {
    const TipRow tip = tip_row(plan.pose, box_, fine_, y);
    const std::size_t line = part.line(y);
    const int first = part.x0 - box_.x;
    tip_.row(tip, first, {part.value.data() + line, width});
    const Cells touched = touched_cells({part.value.data() + line, width});
    part.touched[at(y - part.y0)] = touched;
    if (touched.begin == touched.end) continue;
    const std::ptrdiff_t cell =
        static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side + touched.begin;
    const std::size_t begin = line + at(touched.begin);
    measure_row(plan, {tip.u(first), tip.v(first + touched.begin), tip.du, tip.dv},
                touched.end - touched.begin, part.value.data() + begin, tile.base_m.data() + cell,
                tile.depth_m.data() + cell,
                {part.touch.data() + begin, part.grasp.data() + begin, part.share.data() + begin});
  }
}

void DetailStamp::lift_part(const StampPlan& plan, Part& part) {
  const int side = canvas_.layout().side();
  float* depth = canvas_.find(part.tile)->depth_m.data();
  for (int y = part.y0; y < part.y1; ++y) {
    const Cells& touched = part.touched_in(y);
    if (touched.begin == touched.end) continue;
    lift_row(plan.lift, row_of(part, y, touched.begin),
             {part.grasp.data() + part.line(y) + touched.begin, at(touched.end - touched.begin)},
             depth + static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side + touched.begin);
  }
}

/// What the guide's layers are under the part, before it lays.
void DetailStamp::note_layers(const StampPlan& plan, const CanvasState& guide, Part& part) {
  const int k = canvas_.layout().factor();
  part.opening.clear();
  part.target.clear();
  std::vector<float> total(at(guide.layers));
  for (int y = part.y0 / k; y * k < part.y1; ++y) {
    for (int x = part.x0 / k; x * k < part.x1; ++x) {
      const bool known = guide.stroke(x, y) == plan.stroke_id;
      find_totals(guide, amount_, x, y, total);
      part.opening.push_back(known ? LayerOpening{} : opening_of(total));
      part.target.push_back(known ? static_cast<std::int8_t>(layer_on_top(total)) : kOpens);
    }
  }
}

/// In blocks that the guide has just opened every cell waits to be touched.
void DetailStamp::open_part(const StampPlan& plan, const CanvasState& guide, Part& part) {
  const int k = canvas_.layout().factor();
  const int first = part.x0 / k;
  const int columns = (part.x1 - 1) / k - first + 1;
  for (int by = part.y0 / k; by * k < part.y1; ++by) {
    for (int bx = first; bx < first + columns; ++bx) {
      const std::size_t block = at((by - part.y0 / k) * columns + bx - first);
      if (guide.stroke(bx, by) != plan.stroke_id) {
        part.target[block] = kOpens;
      } else if (part.target[block] == kOpens) {
        part.target[block] = static_cast<std::int8_t>(part.opening[block].target);
        await_touch(canvas_, part.tile, bx, by, part.opening[block]);
      }
    }
  }
}

void DetailStamp::lay_part(const StampPlan& plan, Part& part) {
  const DetailLayout& layout = canvas_.layout();
  const int k = layout.factor(), side = layout.side();
  DetailTile& tile = *canvas_.find(part.tile);
  const int first = part.x0 / k, columns = (part.x1 - 1) / k - first + 1;
  std::vector<float> paint(at(plan.stride));
  for (int y = part.y0; y < part.y1; ++y) {
    const Cells& touched = part.touched_in(y);
    if (touched.begin == touched.end) continue;
    const TipRow tip = tip_row(plan.pose, box_, fine_, y);
    const LayerRow row = row_of(part, y, 0);
    float* depth =
        tile.depth_m.data() + static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side;
    const std::size_t line = part.line(y);
    const std::int8_t* targets = part.target.data() + (y / k - part.y0 / k) * columns;
    for (int x = touched.begin; x < touched.end; ++x) {
      const float share = part.share[line + at(x)];
      const int target = targets[(part.x0 + x) / k - first];
      if (!(share > 0) || target == kOpens) continue;
      open_cell(tile, layout, row, part.x0 + x, y, x);
      const int in_box = part.x0 - box_.x + x;
      plan.reservoir->sample(tip.u(in_box), tip.v(in_box), paint.data());
      float part_laid = stamp_laid(plan, paint.data(), part.value[line + at(x)], share).part;
      const float room_m = std::max(0.0f, plan.lay.max_depth_m - depth[x]);
      if (paint[0] * part_laid > room_m) part_laid = room_m / paint[0];
      depth[x] += part_laid * paint[0];
      for (std::size_t c = 0; c < part.channels.size(); ++c)
        row.at(target, static_cast<int>(c), x) += part_laid * paint[1 + at(part.channels[c])];
    }
    mix_layers_row(plan.mix, row_of(part, y, touched.begin),
                   {part.touch.data() + line + touched.begin, at(touched.end - touched.begin)});
  }
}

}  // namespace pentimento
