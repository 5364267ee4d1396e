#include "core/detail/detail_stamp.h"

#include <algorithm>
#include <cmath>

#include "core/detail/open_cells.h"

namespace pentimento {

namespace {
constexpr std::int8_t kOpens = -1;  // a target that is known once the guide has laid

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The tip at several places along the way that its stamp stands for: fine cells would show each
/// stamp of a stroke as a print of its own.
class SweptTip {
 public:
  SweptTip(const StampPlan& plan, float cell_m) : level_(stamp_tip_level(plan, cell_m)) {
    const float travel_m = plan.stamp.travel_m;
    const float cells = std::min(travel_m / cell_m, static_cast<float>(kMostPrints));
    prints_ = std::max(1, static_cast<int>(cells));
    const Vec2f way = plan.stamp.direction;
    const float step_m = travel_m / static_cast<float>(prints_);
    du_ = step_m * (plan.pose.u_x * way.x + plan.pose.u_y * way.y);
    dv_ = step_m * (plan.pose.v_x * way.x + plan.pose.v_y * way.y);
  }
  /// Mean of the tip's value at (u, v) on its way, the stamp's own place in the middle.
  float value(float u, float v) const {
    if (prints_ == 1) return stamp_value(level_, u, v);
    const float first = -0.5f * static_cast<float>(prints_ - 1);
    float sum = 0;
    for (int i = 0; i < prints_; ++i) {
      const float at = first + static_cast<float>(i);
      sum += stamp_value(level_, u + at * du_, v + at * dv_);
    }
    return sum / static_cast<float>(prints_);
  }

 private:
  static constexpr int kMostPrints = 8;
  const TipLevel level_;
  int prints_ = 1;
  float du_ = 0, dv_ = 0;
};

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
}  // namespace

DetailStamp::DetailStamp(DetailCanvas& canvas, std::span<const float> amount,
                         const Threads& threads)
    : canvas_(canvas),
      fine_(canvas.layout().fine()),
      amount_(amount.begin(), amount.end()),
      threads_(threads) {}

void DetailStamp::lift(const StampPlan& plan, const CanvasState& guide) {
  find_parts(plan);
  for (Part& part : parts_) {
    canvas_.at(part.tile);
    find_planes(part);
  }
  threads_.for_ranges(0, static_cast<int>(parts_.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Part& part = parts_[at(i)];
      if (!part.usable) continue;
      measure(plan, part);
      lift_part(plan, part);
      note_layers(plan, guide, part);
    }
  });
}

void DetailStamp::lay(const StampPlan& plan, const CanvasState& guide) {
  for (Part& part : parts_) {
    const int k = canvas_.layout().factor();
    canvas_.cover(part.tile, guide,
                  {part.x0 / k, (part.x1 + k - 1) / k, part.y0 / k, (part.y1 + k - 1) / k});
    find_planes(part);
  }
  threads_.for_ranges(0, static_cast<int>(parts_.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (!parts_[at(i)].usable) continue;
      open_part(plan, guide, parts_[at(i)]);
      lay_part(plan, parts_[at(i)]);
    }
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
  parts_.clear();
  if (box_.empty()) return;
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.side();
  for (int row = box_.y / side; row * side < box_.y + box_.height; ++row) {
    for (int column = box_.x / side; column * side < box_.x + box_.width; ++column) {
      Part part;
      part.tile = layout.tile_of(column, row);
      part.x0 = std::max(box_.x, column * side);
      part.x1 = std::min(box_.x + box_.width, (column + 1) * side);
      part.y0 = std::max(box_.y, row * side);
      part.y1 = std::min(box_.y + box_.height, (row + 1) * side);
      parts_.push_back(std::move(part));
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

LayerRow DetailStamp::row_of(const Part& part, int y) const {
  const int side = canvas_.layout().side();
  return {part.planes, static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side,
          canvas_.layers(), static_cast<int>(part.channels.size()), part.amount};
}

/// The tip's value, its hold and the levelled share of each cell, before anything is lifted.
void DetailStamp::measure(const StampPlan& plan, Part& part) {
  const int side = canvas_.layout().side();
  const DetailTile& tile = *canvas_.find(part.tile);
  const SweptTip swept(plan, std::sqrt(fine_.dx_m() * fine_.dy_m()));
  const std::size_t cells = at(part.width()) * at(part.y1 - part.y0);
  for (std::vector<float>* v : {&part.value, &part.share, &part.touch, &part.grasp})
    v->resize(cells);
  std::size_t i = 0;
  for (int y = part.y0; y < part.y1; ++y) {
    const TipRow tip = tip_row(plan.pose, box_, fine_, y);
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side;
    const float* base = tile.base_m.data() + first;
    const float* depth = tile.depth_m.data() + first;
    for (int x = 0; x < part.width(); ++x, ++i) {
      const float u = tip.u(part.x0 - box_.x + x), v = tip.v(part.x0 - box_.x + x);
      const float value = swept.value(u, v);
      part.value[i] = value;
      part.touch[i] = value > 0 ? stamp_touch(plan, value, v) : 0.0f;
      part.grasp[i] = stamp_lift_weight(plan, part.touch[i], value, {depth[x], base[x] + depth[x]});
      part.share[i] =
          value > 0 ? plan.share_scale * stamp_levelled(plan, value, base[x] + depth[x]) : 0.0f;
    }
  }
}

void DetailStamp::lift_part(const StampPlan& plan, Part& part) {
  const int side = canvas_.layout().side();
  const std::size_t width = at(part.width());
  const int stride = 1 + static_cast<int>(part.channels.size());
  std::vector<float> lifted(width * at(stride));
  std::vector<double> sums(at(stride));
  float* depth = canvas_.find(part.tile)->depth_m.data();
  for (int y = part.y0; y < part.y1; ++y)
    lift_row(plan.lift, row_of(part, y), {part.grasp.data() + at(y - part.y0) * width, width},
             depth + static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side, lifted.data(),
             stride, sums);
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
  const std::size_t width = at(part.width());
  float* depth_plane = tile.depth_m.data();
  std::vector<float> paint(at(plan.stride));
  for (int y = part.y0; y < part.y1; ++y) {
    const TipRow tip = tip_row(plan.pose, box_, fine_, y);
    const LayerRow row = row_of(part, y);
    float* depth = depth_plane + static_cast<std::ptrdiff_t>(y % side) * side + part.x0 % side;
    const std::size_t line = at(y - part.y0) * width;
    for (int x = 0; x < part.width(); ++x) {
      const float share = part.share[line + at(x)];
      const int bx = (part.x0 + x) / k;
      const int target = part.target[at((y / k - part.y0 / k) * columns + bx - first)];
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
    mix_layers_row(plan.mix, row, {part.touch.data() + line, width});
  }
}

}  // namespace pentimento
