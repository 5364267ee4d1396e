#include "core/brush/stamp_cells.h"

#include <algorithm>
#include <bit>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"
#include "core/base/scratch.h"
#include "core/layers/cell_packet.h"

namespace pentimento {

namespace {
constexpr std::size_t kLongRun = kPacketCells;        // cells: a run of them needs no company
constexpr std::size_t kBandCells = 8 * kPacketCells;  // gathered: some planes fit the first cache
constexpr std::size_t kLineFloats = 16;               // floats of a cache line

/// from[runs] -> cells. Returns whether any bit of them is set.
template <typename T>
inline bool gather_values(const T* from, const CellRun* runs, std::size_t count,
                          T* __restrict cells) {
  std::uint32_t any = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const CellRun run = runs[k];
    const T* __restrict in = from + run.offset;
    T* __restrict out = cells + run.at;
    for (std::size_t i = 0; i < run.count; ++i) {
      out[i] = in[i];
      any |= std::bit_cast<std::uint32_t>(in[i]);
    }
  }
  return any != 0;
}
template <typename T>
inline void put_back_values(const T* cells, const CellRun* runs, std::size_t count, T* to) {
  for (std::size_t k = 0; k < count; ++k) {
    const CellRun run = runs[k];
    const T* __restrict in = cells + run.at;
    T* __restrict out = to + run.offset;
    for (std::size_t i = 0; i < run.count; ++i) out[i] = in[i];
  }
}

PENTIMENTO_KERNEL
bool gather_runs(const float* from, const CellRun* runs, std::size_t count, float* cells) {
  return gather_values(from, runs, count, cells);
}
PENTIMENTO_KERNEL
void put_back_runs(const float* cells, const CellRun* runs, std::size_t count, float* to) {
  put_back_values(cells, runs, count, to);
}
}  // namespace

StampCells::StampCells(CanvasState& state, std::span<const float> amount)
    : state_(state), planes_(state, amount), cells_(state.pigment.size()) {}

void StampCells::cut(const FootprintBox& box, std::span<const TouchedCells> rows) {
  planes_.find(state_);
  runs_.clear();
  bands_.clear();
  std::size_t all = 0;
  for (int y = 0; y < box.height; ++y) {
    const TouchedCells& row = rows[static_cast<std::size_t>(y)];
    const std::size_t count = row.count();
    runs_.push_back({planes_.row(box.x + row.begin, box.y + y).offset, row.at, count});
    all = std::max(all, row.at + count);
    if (count == 0) continue;
    // A short run goes to the short runs before it, as long as they are few.
    const bool joins = !bands_.empty() && count < kLongRun && bands_.back().cells < kBandCells &&
                       (!stays(bands_.back()) || bands_.back().cells < kLongRun);
    if (!joins) bands_.push_back({y, y, row.at, 0});
    bands_.back().end = y + 1;
    bands_.back().cells += count;
  }
  const std::size_t pitch = (all + kLineFloats - 1) / kLineFloats * kLineFloats;
  grow(pigment_, pitch * cells_.size());
  grow(depth_m_, pitch);
  grow(stroke_, pitch);
  grow(held_, bands_.size() * cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k] = pigment_.data() + k * pitch;
}

std::span<const CellRun> StampCells::runs_of(const StampBand& band) const {
  return std::span(runs_).subspan(static_cast<std::size_t>(band.begin),
                                  static_cast<std::size_t>(band.end - band.begin));
}

std::span<std::uint8_t> StampCells::held(int band) {
  return std::span(held_).subspan(static_cast<std::size_t>(band) * cells_.size(), cells_.size());
}

BandPaint StampCells::gather(int band) {
  const StampBand& b = bands_[static_cast<std::size_t>(band)];
  if (stays(b)) return paint(band);
  const std::span<const CellRun> runs = runs_of(b);
  const std::span<float* const> from = planes_.row(0, 0).plane;
  const std::span<std::uint8_t> held = this->held(band);
  for (std::size_t k = 0; k < cells_.size(); ++k)
    held[k] = gather_runs(from[k], runs.data(), runs.size(), cells_[k]) ? 1 : 0;
  gather_runs(state_.depth_m.row(0), runs.data(), runs.size(), depth_m_.data());
  gather_values(state_.stroke.row(0), runs.data(), runs.size(), stroke_.data());
  return paint(band);
}

BandPaint StampCells::paint(int band) {
  const StampBand& b = bands_[static_cast<std::size_t>(band)];
  if (stays(b)) {
    const CellRun& run = runs_[static_cast<std::size_t>(b.begin)];
    LayerRow row = planes_.row(0, 0);
    row.offset = run.offset;
    return {row, {state_.depth_m.row(0) + run.offset, b.cells}, state_.stroke.row(0) + run.offset};
  }
  LayerRow row = planes_.row(0, 0);
  row.plane = cells_;
  row.offset = static_cast<std::ptrdiff_t>(b.at);
  row.holds = held(band);
  return {row, {depth_m_.data() + b.at, b.cells}, stroke_.data() + b.at};
}

void StampCells::find_held(int band) {
  const StampBand& b = bands_[static_cast<std::size_t>(band)];
  if (stays(b)) return;
  const std::span<std::uint8_t> held = this->held(band);
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (held[k] == 0 && any_not_zero(cells_[k] + b.at, static_cast<int>(b.cells))) held[k] = 1;
}

void StampCells::put_back(int band) {
  const StampBand& b = bands_[static_cast<std::size_t>(band)];
  if (stays(b)) return;
  find_held(band);
  const std::span<const CellRun> runs = runs_of(b);
  const std::span<float* const> to = planes_.row(0, 0).plane;
  const std::span<const std::uint8_t> held = this->held(band);
  // Planes without paint are not written to: they may have no memory yet.
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (held[k] != 0) put_back_runs(cells_[k], runs.data(), runs.size(), to[k]);
  put_back_runs(depth_m_.data(), runs.data(), runs.size(), state_.depth_m.row(0));
  put_back_values(stroke_.data(), runs.data(), runs.size(), state_.stroke.row(0));
}

}  // namespace pentimento
