#include "core/fluid/conservative/tiles/sleep_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

int tile_cells(float tile_m, float cell_m, int side) {
  int cells = 8;
  while (cells < side && static_cast<float>(2 * cells) * cell_m <= tile_m * 1.0001f) cells *= 2;
  return cells;
}

// A velocity without its sign, as bits. Positive floats have the order of their bits, and a maximum
// of integers may be taken in any order, so the compiler takes many at a time.
std::int32_t size_bits(float u) {
  return std::bit_cast<std::int32_t>(u) & 0x7fffffff;
}

// Raises `most_u` and `most_v` to the sizes of two rows of velocities. Returns whether any of them
// is not 0.
PENTIMENTO_KERNEL
bool raise_row(const float* __restrict u, const float* __restrict v, int n,
               std::int32_t* __restrict most_u, std::int32_t* __restrict most_v) {
  std::int32_t any = 0;
  for (int i = 0; i < n; ++i) {
    const std::int32_t size_u = std::bit_cast<std::int32_t>(u[i]) & 0x7fffffff;
    const std::int32_t size_v = std::bit_cast<std::int32_t>(v[i]) & 0x7fffffff;
    most_u[i] = size_u > most_u[i] ? size_u : most_u[i];
    most_v[i] = size_v > most_v[i] ? size_v : most_v[i];
    any |= size_u | size_v;
  }
  return any != 0;
}

void note_gravity(const Vec3f& gravity_m_s2, float* rest) {
  rest[kGravityX] = gravity_m_s2.x;
  rest[kGravityY] = gravity_m_s2.y;
  rest[kGravityZ] = gravity_m_s2.z;
}

int cells_travelled(float travel) {
  return static_cast<int>(std::min(travel, 1e6f)) + 3;  // rounded up, and two cells more
}

}  // namespace

SleepTiles::SleepTiles(const CanvasGeometry& geometry, float tile_m)
    : width_(geometry.width),
      height_(geometry.height),
      dx_m_(geometry.dx_m()),
      dy_m_(geometry.dy_m()),
      tile_width_(tile_cells(tile_m, dx_m_, width_)),
      tile_height_(tile_cells(tile_m, dy_m_, height_)),
      columns_((width_ + tile_width_ - 1) / tile_width_),
      rows_((height_ + tile_height_ - 1) / tile_height_),
      awake_(static_cast<std::size_t>(count()), 0),
      disturbed_(awake_),
      moving_(awake_) {}

CellBox SleepTiles::box(int tile) const {
  const int x0 = tile % columns_ * tile_width_;
  const int y0 = tile / columns_ * tile_height_;
  return {x0, std::min(x0 + tile_width_, width_), y0, std::min(y0 + tile_height_, height_)};
}

void SleepTiles::Motion::add(int x, int y, float cells_x, float cells_y) {
  if (box.empty()) {
    box = {x, x + 2, y, y + 2};
  } else {
    box = {std::min(box.x0, x), std::max(box.x1, x + 2), std::min(box.y0, y),
           std::max(box.y1, y + 2)};
  }
  travel_x = std::max(travel_x, std::abs(cells_x));
  travel_y = std::max(travel_y, std::abs(cells_y));
}

SleepTiles::Motion SleepTiles::flow_in(const CanvasState& state, int tile, float dt_s) const {
  const CellBox b = box(tile);
  const int left = std::max(b.x0 - 1, 0);
  const int n = b.x1 - b.x0;
  const auto columns = static_cast<std::size_t>(b.x1 - left);
  std::vector<std::int32_t> most(2 * columns, 0);  // of each column, the size of u, then of v
  std::int32_t* most_u = most.data();
  std::int32_t* most_v = most_u + columns;
  Motion m;
  for (int y = std::max(b.y0 - 1, 0); y < b.y1; ++y) {
    const float* u = state.velocity_x_m_s.row(y);
    const float* v = state.velocity_y_m_s.row(y);
    bool moves = raise_row(u + b.x0, v + b.x0, n, most_u + (b.x0 - left), most_v + (b.x0 - left));
    if (left < b.x0) {  // on its own, so that the others fill whole vectors
      most_u[0] = std::max(most_u[0], size_bits(u[left]));
      most_v[0] = std::max(most_v[0], size_bits(v[left]));
      moves |= (size_bits(u[left]) | size_bits(v[left])) != 0;
    }
    if (!moves) continue;
    if (m.box.empty()) m.box.y0 = y;
    m.box.y1 = y + 2;
    m.box.x1 = 1;  // not empty; the columns follow
  }
  if (m.box.empty()) return m;
  m.box.x0 = b.x1;
  for (std::size_t i = 0; i < columns; ++i) {
    if ((most_u[i] | most_v[i]) == 0) continue;
    const int x = left + static_cast<int>(i);
    m.box.x0 = std::min(m.box.x0, x);
    m.box.x1 = x + 2;
    m.travel_x = std::max(m.travel_x, std::bit_cast<float>(most_u[i]) * (dt_s / dx_m_));
    m.travel_y = std::max(m.travel_y, std::bit_cast<float>(most_v[i]) * (dt_s / dy_m_));
  }
  return m;
}

SleepTiles::Motion SleepTiles::touch_in(const BrushContact& contact, int tile) const {
  const CellBox b = box(tile);
  const int begin = std::max(b.x0, contact.column_begin);
  const int end = std::min(b.x1, contact.column_end);
  Motion m;
  for (int y = std::max(b.y0, contact.row_begin); y < std::min(b.y1, contact.row_end); ++y) {
    const float* weight = contact.weight.row(y);
    const float* push_x = contact.push_x_m.row(y);
    const float* push_y = contact.push_y_m.row(y);
    for (int x = begin; x < end; ++x)
      if (weight[x] > 0 || push_x[x] != 0 || push_y[x] != 0)
        m.add(x, y, push_x[x] / dx_m_, push_y[x] / dy_m_);
  }
  return m;
}

void SleepTiles::wake_around(const Motion& motion) {
  if (motion.box.empty()) return;
  const int travel_x = cells_travelled(motion.travel_x);
  const int travel_y = cells_travelled(motion.travel_y);
  const int column_begin = std::max(motion.box.x0 - travel_x, 0) / tile_width_;
  const int column_end = std::min((motion.box.x1 + travel_x - 1) / tile_width_ + 1, columns_);
  const int row_begin = std::max(motion.box.y0 - travel_y, 0) / tile_height_;
  const int row_end = std::min((motion.box.y1 + travel_y - 1) / tile_height_ + 1, rows_);
  for (int row = row_begin; row < row_end; ++row)
    for (int column = column_begin; column < column_end; ++column)
      awake_[static_cast<std::size_t>(row * columns_ + column)] = 1;
}

void SleepTiles::wake_touched(const BrushContact& contact) {
  touched_ = {};
  if (contact.empty()) return;
  const int begin = contact.row_begin / tile_height_ * columns_;
  const int end = ((contact.row_end - 1) / tile_height_ + 1) * columns_;
  for (int tile = begin; tile < end; ++tile) {
    const Motion touch = touch_in(contact, tile);
    if (touch.box.empty()) continue;
    disturbed_[static_cast<std::size_t>(tile)] = 1;
    wake_around(touch);
    const int travel_x = cells_travelled(touch.travel_x);
    const int travel_y = cells_travelled(touch.travel_y);
    const CellBox near{touch.box.x0 - travel_x, touch.box.x1 + travel_x, touch.box.y0 - travel_y,
                       touch.box.y1 + travel_y};
    touched_ = touched_.empty()
                   ? near
                   : CellBox{std::min(touched_.x0, near.x0), std::max(touched_.x1, near.x1),
                             std::min(touched_.y0, near.y0), std::max(touched_.y1, near.y1)};
  }
}

void SleepTiles::wake_by_gravity(const CanvasState& state, const StepInput& in) {
  const Vec3f g = in.gravity_m_s2;
  for (std::size_t tile = 0; tile < awake_.size(); ++tile) {
    const float* rest = &state.sleep[tile * kSleepValues];
    const float change = std::max({std::abs(g.x - rest[kGravityX]), std::abs(g.y - rest[kGravityY]),
                                   std::abs(g.z - rest[kGravityZ])});
    if (rest[kFeelsGravity] != 0 && change >= in.model.wake_gravity_m_s2) awake_[tile] = 1;
  }
}

void SleepTiles::rest_fresh(CanvasState& state, const StepInput& in) const {
  state.sleep.assign(awake_.size() * kSleepValues, 0);
  for (std::size_t tile = 0; tile < awake_.size(); ++tile) {
    if (awake_[tile]) continue;
    float* rest = &state.sleep[tile * kSleepValues];
    rest[kAsleep] = 1;
    note_gravity(in.gravity_m_s2, rest);
  }
}

void SleepTiles::wake(const CanvasState& state, const StepInput& in) {
  std::fill(moving_.begin(), moving_.end(), std::uint8_t{0});
  const bool remembers = state.sleep.size() == awake_.size() * kSleepValues;
  for (std::size_t tile = 0; tile < awake_.size(); ++tile)
    awake_[tile] = remembers ? state.sleep[tile * kSleepValues + kAsleep] == 0 : !in.fresh;
  if (remembers) wake_by_gravity(state, in);

  list_awake();
  std::vector<Motion> motion(list_.size());
  in.threads.for_ranges(0, static_cast<int>(list_.size()), 16, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      motion[k] = flow_in(state, list_[k], in.dt_s);
  });
  travel_cells_ = 0;
  moves_ = false;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    travel_cells_ = std::max({travel_cells_, motion[k].travel_x, motion[k].travel_y});
    moving_[static_cast<std::size_t>(list_[k])] = !motion[k].box.empty();
    moves_ |= !motion[k].box.empty();
    wake_around(motion[k]);
  }
  disturbed_ = moving_;
  wake_touched(in.contact);
  list_awake();
  list_runs();
  list_strips();
}

void SleepTiles::fall_asleep(CanvasState& state, const StepInput& in,
                             const std::function<bool(const CellBox&)>& feels_gravity) {
  state.sleep.resize(awake_.size() * kSleepValues, 0);
  in.threads.for_ranges(0, static_cast<int>(list_.size()), 16, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const int tile = list_[k];
      float* rest = &state.sleep[static_cast<std::size_t>(tile) * kSleepValues];
      const bool rests =
          !disturbed_[static_cast<std::size_t>(tile)] && flow_in(state, tile, in.dt_s).box.empty();
      rest[kAsleep] = rests ? 1.0f : 0.0f;
      if (!rests) continue;
      note_gravity(in.gravity_m_s2, rest);
      rest[kFeelsGravity] = feels_gravity(box(tile)) ? 1.0f : 0.0f;
    }
  });
}

void SleepTiles::list_awake() {
  list_.clear();
  for (int tile = 0; tile < count(); ++tile)
    if (awake_[static_cast<std::size_t>(tile)]) list_.push_back(tile);
}

void SleepTiles::list_runs() {
  runs_.clear();
  for (int row = 0; row < rows_; ++row) {
    const std::size_t first = runs_.size();
    const int y0 = row * tile_height_;
    for (int column = 0; column < columns_; ++column) {
      if (!awake(column, row)) continue;
      const CellBox b = box(row * columns_ + column);
      if (runs_.size() > first && runs_.back().x1 == b.x0)
        runs_.back().x1 = b.x1;
      else
        runs_.push_back({y0, b.x0, b.x1});
    }
    const std::size_t end = runs_.size();
    for (int y = y0 + 1; y < std::min(y0 + tile_height_, height_); ++y)
      for (std::size_t k = first; k < end; ++k) runs_.push_back({y, runs_[k].x0, runs_[k].x1});
  }
}

void SleepTiles::list_strips() {
  strips_.clear();
  for (int column = 0; column < columns_; ++column) {
    bool open = false;
    for (int row = 0; row < rows_; ++row) {
      const bool here = awake(column, row);
      const CellBox b = box(row * columns_ + column);
      if (here && open)
        strips_.back().y1 = b.y1;
      else if (here)
        strips_.push_back(b);
      open = here;
    }
  }
}

}  // namespace pentimento::conservative
