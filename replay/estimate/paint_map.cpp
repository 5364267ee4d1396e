#include "replay/estimate/paint_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento {

namespace {
bool overlap(const CellBox& a, const CellBox& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}
}  // namespace

PaintMap::PaintMap(const LogSession& session, const DetailCost& cost)
    : grid_(session.grid),
      layout_(session.grid, session.detail),
      cost_(cost),
      layers_(session.model.layers),
      channels_(session.basis.channels()),
      bands_(session.basis.bands()),
      wet_(session.grid.width, session.grid.height),
      dried_(session.grid.width, session.grid.height),
      awake_(session.grid),
      step_s_(1 / session.reader->header().steps_per_second),
      sleep_tile_m_(session.model.sleep_tile_m),
      full_(session.start.has_value()) {
  if (session.start) begin(session.start->state);
}

void PaintMap::reach(const CellBox& box) {
  if (reached_.empty()) {
    reached_ = box;
    return;
  }
  reached_ = {std::min(reached_.x0, box.x0), std::max(reached_.x1, box.x1),
              std::min(reached_.y0, box.y0), std::max(reached_.y1, box.y1)};
}

void PaintMap::begin(const CanvasState& state) {
  reach({0, grid_.width, 0, grid_.height});
  const std::int64_t settling = settling_steps(BrushSettings());
  std::vector<float> paper_m(static_cast<std::size_t>(grid_.width));
  for (int y = 0; y < grid_.height; ++y) {
    read_paper(state, 0, y, paper_m);
    for (int x = 0; x < grid_.width; ++x) {
      WetCell& wet = wet_(x, y);
      for (std::size_t p = 0; p < state.pigment.size(); ++p) {
        const auto c = p % static_cast<std::size_t>(state.channels);
        if (c >= CarriedPaint::kChannels || !(state.pigment[p](x, y) > 0)) continue;
        wet.mask |= 1u << c;
        wet.main = wet.mask;
        wet.layers = static_cast<int>(p / static_cast<std::size_t>(state.channels)) + 1;
      }
      if (wet.layers > 0) awake_.touch(x, y, {wet.mask, 0, settling});
      dried_(x, y) = state.base_m(x, y) != paper_m[static_cast<std::size_t>(x)] ? 1 : 0;
    }
  }
}

CarriedPaint::Contact PaintMap::deposit(const Deposition& deposition) {
  CarriedPaint::Contact contact;
  const TipPose& pose = deposition.pose;
  const Tip& tip = deposition.tip;
  const FootprintBox box = box_of(pose, tip.extent(), grid_);
  if (box.empty()) return contact;
  reach({box.x, box.x + box.width, box.y, box.y + box.height});
  const TipLevel& level = tip.level_for(cell_size_m(grid_) / pose.diameter_m);
  std::uint32_t touched = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const TipRow row = tip_row(pose, box, grid_, y);
    for (int x = 0; x < box.width; ++x) {
      if (!(level.at(row.u(x), row.v(x)) > 0)) continue;
      const int band = CarriedPaint::band_of(row.v(x));
      WetCell& cell = wet_(box.x + x, y);
      contact.add(band, cell.main & ~deposition.paint.loaded(band));
      deposit(cell, deposition.paint.deposited(band), deposition.stroke);
      cell.main |= deposition.paint.loaded(band);
      cell.thin = deposits_thin_paint(deposition.brush) ? 1 : 0;
      touched |= cell.mask;
    }
  }
  awake_.touch(box.x, box.y, box.width, box.height,
               {touched, deposition.step, settling_steps(deposition.brush)});
  ++survey_.stamps;
  return contact;
}

void PaintMap::deposit(WetCell& cell, std::uint32_t mask, std::uint32_t stroke) {
  survey_.stamped_cells += 1;
  if (mask == 0 && cell.layers == 0) return;
  if (cell.layers == 0 || cell.stroke != stroke) cell.layers = std::min(cell.layers + 1, layers_);
  cell.mask |= mask;
  cell.stroke = stroke;
  survey_.stamped_channels += std::popcount(cell.mask);
}

void PaintMap::tilt(double x_m_s2, double y_m_s2, std::int64_t step) {
  awake_.tilt(std::hypot(x_m_s2, y_m_s2), step);
  tilted_.tilt(x_m_s2, y_m_s2, static_cast<double>(step) * step_s_);
}

/// Thin paint gets to where it will have run on the tilted canvas, into all layers there.
void PaintMap::run_down() {
  const auto thin = [&](int x, int y) { return wet_(x, y).thin != 0; };
  for_drips(grid_, CellBox(reached_), tilted_, thin, [&](int from_x, int from_y, int x, int y) {
    reach({x, x + 1, y, y + 1});
    WetCell& cell = wet_(x, y);
    cell.mask |= wet_(from_x, from_y).mask;
    cell.layers = layers_;
  });
  tilted_.forget();
}

/// What it held until step `step`, before it holds less.
void PaintMap::account(std::int64_t step) {
  tilted_.pass(static_cast<double>(step) * step_s_);
  run_down();
  measure();
}

void PaintMap::dry(std::int64_t step) {
  account(step);
  awake_.clear();
  for (int y = reached_.y0; y < reached_.y1; ++y)
    for (int x = reached_.x0; x < reached_.x1; ++x) {
      if (wet_(x, y).layers > 0) dried_(x, y) = 1;
      wet_(x, y) = {};
    }
}

void PaintMap::clear(std::int64_t step) {
  account(step);
  for (int y = reached_.y0; y < reached_.y1; ++y) {
    std::fill_n(wet_.row(y) + reached_.x0, reached_.width(), WetCell());
    std::fill_n(dried_.row(y) + reached_.x0, reached_.width(), std::uint8_t{0});
  }
  awake_.clear();
}

/// The detail canvas as it would be now.
void PaintMap::measure() {
  std::int64_t bytes = 0, used = 0;
  for (int t = 0; t < layout_.tiles(); ++t) {
    const std::int64_t tile = tile_bytes(layout_.box(t));
    bytes += cost_.bare_tile + tile;
    used += tile > 0 ? 1 : 0;
  }
  survey_.detail_bytes = std::max(survey_.detail_bytes, static_cast<double>(bytes));
  survey_.tiles = std::max(survey_.tiles, used);
}

std::int64_t PaintMap::tile_bytes(const CellBox& box) const {
  if (!overlap(box, reached_)) return 0;
  std::vector<std::uint32_t> rows;  // channels that are wet in it, row by row for each layer
  bool dried = false;
  for (int layer = 0; layer < layers_; ++layer)
    for (int y = box.y0; y < box.y1; ++y) {
      std::uint32_t& row = rows.emplace_back(0);
      for (int x = box.x0; x < box.x1; ++x) {
        const WetCell& cell = wet_(x, y);
        if (cell.layers > layer) row |= cell.mask;
        dried = dried || dried_(x, y) != 0;
      }
    }
  const auto height = static_cast<std::size_t>(box.height());
  const std::span<const std::uint32_t> all = rows;
  const std::int64_t depth = written_bytes(all.first(height), ~0u);
  if (depth == 0 && !dried) return 0;
  // The relief, and what has dried on it, are written whole.
  const std::int64_t plane = cost_.cell * layout_.side() * layout_.side();
  std::int64_t bytes = depth + plane * (1 + (dried ? bands_ : 0));
  for (std::size_t row = 0; row < all.size(); row += height)
    for (int c = 0; c < std::min(channels_, CarriedPaint::kChannels); ++c)
      bytes += written_bytes(all.subspan(row, height), 1u << c);
  return bytes;
}

/// Memory that counts of a wet plane with paint of `mask` in it.
std::int64_t PaintMap::written_bytes(std::span<const std::uint32_t> rows,
                                     std::uint32_t mask) const {
  const std::int64_t row = cost_.cell * layout_.side() * layout_.factor();
  std::int64_t end = 0, bytes = 0;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if ((rows[y] & mask) == 0) continue;
    const auto i = static_cast<std::int64_t>(y);
    const std::int64_t from = std::max(end, i * row / cost_.page * cost_.page);
    end = ((i + 1) * row + cost_.page - 1) / cost_.page * cost_.page;
    bytes += end - from;
  }
  return bytes;
}

PaintSurvey PaintMap::finish(std::int64_t end_step) {
  account(end_step);
  awake_.finish(end_step);
  survey_.awake = awake_.awake();
  survey_.tilted_cell_steps = awake_.tilted_cell_steps();
  survey_.all_tiles = layout_.tiles();
  std::tie(survey_.reached_share, survey_.used_share) = sleep_tile_shares();
  return survey_;
}

std::pair<double, double> PaintMap::sleep_tile_shares() const {
  if (full_ || awake_.tilted_cell_steps() > 0) return {1, 1};
  const conservative::SleepTiles tiles(grid_, sleep_tile_m_);
  return {awake_.reached_share(tiles.tile_width(), tiles.tile_height()),
          awake_.most_used_share(tiles.tile_width(), tiles.tile_height())};
}

}  // namespace pentimento
