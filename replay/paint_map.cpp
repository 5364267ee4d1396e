#include "replay/paint_map.h"

#include <algorithm>
#include <bit>

namespace pentimento {

PaintMap::PaintMap(const LogSession& session, const DetailCost& cost)
    : grid_(session.grid),
      layout_(session.grid, session.detail),
      cost_(cost),
      layers_(session.model.layers),
      channels_(session.basis.channels()),
      bands_(session.basis.bands()),
      wet_(cells(), 0),
      dried_(cells(), 0),
      awake_(session.grid) {
  if (session.start) begin(session.start->state);
}

void PaintMap::begin(const CanvasState& state) {
  const std::int64_t settling = settling_steps(BrushSettings());
  for (int y = 0; y < grid_.height; ++y)
    for (int x = 0; x < grid_.width; ++x) {
      std::uint32_t& wet = wet_[at(x, y)];
      for (std::size_t p = 0; p < state.pigment.size(); ++p) {
        const auto c = p % static_cast<std::size_t>(state.channels);
        if (c < 32 && state.pigment[p](x, y) > 0) wet |= 1u << c;
      }
      if (wet != 0) awake_.touch(x, y, {wet, 0, settling});
      dried_[at(x, y)] = state.base_m(x, y) != state.paper_m(x, y) ? 1 : 0;
    }
}

std::uint32_t PaintMap::lay(const Laying& laying) {
  const TipPose& pose = laying.pose;
  const Tip& tip = laying.tip;
  const CellBox box = box_of(pose, tip.extent(), grid_);
  if (box.empty()) return 0;
  const TipLevel& level = tip.level_for(grid_.dx_m() / pose.diameter_m);
  std::uint32_t met = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const TipRow row = tip_row(pose, box, grid_, y);
    for (int x = 0; x < box.width; ++x) {
      if (!(level.at(row.u(x), row.v(x)) > 0)) continue;
      std::uint32_t& cell = wet_[at(box.x + x, y)];
      met |= cell;
      cell |= laying.mask;
      survey_.stamped_cells += 1;
      survey_.stamped_channels += std::popcount(cell);
    }
  }
  awake_.touch(box.x, box.y, box.width, box.height,
               {laying.mask, laying.step, laying.settling_steps});
  ++survey_.stamps;
  return met;
}

void PaintMap::dry() {
  measure();
  awake_.clear();
  for (std::size_t i = 0; i < wet_.size(); ++i) {
    if (wet_[i] != 0) dried_[i] = 1;
    wet_[i] = 0;
  }
}

void PaintMap::clear() {
  std::fill(wet_.begin(), wet_.end(), 0u);
  std::fill(dried_.begin(), dried_.end(), std::uint8_t{0});
  awake_.clear();
}

/// The finer canvas as it would be now.
void PaintMap::measure() {
  double bytes = 0;
  std::int64_t used = 0;
  for (int t = 0; t < layout_.tiles(); ++t) {
    const GuideBox box = layout_.box(t);
    std::uint32_t wet = 0;
    bool dried = false;
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        wet |= wet_[at(x, y)];
        dried = dried || dried_[at(x, y)] != 0;
      }
    bytes += cost_.bare_tile;
    if (wet == 0 && !dried) continue;
    ++used;
    const double fine = static_cast<double>(layout_.side()) * layout_.side();
    const int planes = layers_ * std::min(std::popcount(wet), channels_);
    bytes += fine * (wet != 0 ? cost_.wet_cell + planes * cost_.pigment_cell : cost_.base_cell);
    if (dried) bytes += fine * bands_ * cost_.dried_band;
  }
  survey_.detail_bytes = std::max(survey_.detail_bytes, bytes);
  survey_.tiles = std::max(survey_.tiles, used);
}

PaintSurvey PaintMap::finish(std::int64_t end_step) {
  measure();
  awake_.finish(end_step);
  survey_.awake = awake_.awake();
  survey_.tilted_cell_steps = awake_.tilted_cell_steps();
  survey_.all_tiles = layout_.tiles();
  return survey_;
}

}  // namespace pentimento
