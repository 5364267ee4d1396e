#include "core/detail/stamp/detail_stamp.h"

#include <algorithm>

#include "core/detail/stamp/stamp_rows.h"
#include "core/detail/store/open_cells.h"

namespace pentimento {

namespace {
constexpr std::size_t kMostWaiting = 16;  // their tips stay in a core's own cache
constexpr int kBandRows = 32;             // of fine cells: with a dozen planes, a core's own cache
}  // namespace

DetailStamp::DetailStamp(DetailCanvas& canvas, std::span<const float> amount,
                         const Threads& threads)
    : canvas_(canvas), amount_(amount.begin(), amount.end()), threads_(threads) {}

void DetailStamp::begin() {
  if (used_ == kMostWaiting) finish();
  if (used_ == stamps_.size()) stamps_.push_back(std::make_unique<QueuedStamp>(canvas_.channels()));
  ++used_;
}

void DetailStamp::before_deposit(const StampPlan& plan, const CanvasState& guide) {
  stamps_[used_ - 1]->before_deposit(plan, guide, canvas_.layout(), amount_);
}

void DetailStamp::add_touched(ChangedBlocks& blocks) {
  QueuedStamp& stamp = *stamps_[used_ - 1];
  stamp.find_touched(canvas_.layout());
  for (int y = stamp.blocks().y0; y < stamp.blocks().y1; ++y) {
    const QueuedStamp::BlockSpan touched = stamp.touched_blocks(y, canvas_.layout());
    blocks.add(y, touched.x0, touched.x1);
  }
}

void DetailStamp::after_deposit(const StampPlan& plan, const CanvasState& guide) {
  QueuedStamp& stamp = *stamps_[used_ - 1];
  stamp.after_deposit(plan, guide);
  const CellBox& blocks = stamp.blocks();
  for_tiles(blocks, [&](int tile) {
    const CellBox box = canvas_.layout().box(tile);
    canvas_.ensure_planes(tile, guide,
                          {std::max(box.x0, blocks.x0), std::min(box.x1, blocks.x1),
                           std::max(box.y0, blocks.y0), std::min(box.y1, blocks.y1)});
  });
}

/// Calls body(tile) for the tiles that have a part of `blocks`.
template <typename Body>
void DetailStamp::for_tiles(const CellBox& blocks, const Body& body) const {
  const DetailLayout& layout = canvas_.layout();
  const int side = layout.blocks();
  if (blocks.x0 >= blocks.x1) return;
  for (int row = blocks.y0 / side; row * side < blocks.y1; ++row)
    for (int column = blocks.x0 / side; column * side < blocks.x1; ++column)
      body(layout.tile_of(column, row));
}

std::vector<DetailStamp::TileWork> DetailStamp::list_work() const {
  std::vector<TileWork> works;
  std::vector<std::pair<int, std::size_t>> listed;  // tile, stamp
  for (std::size_t i = 0; i < used_; ++i)
    for_tiles(stamps_[i]->blocks(), [&](int tile) { listed.emplace_back(tile, i); });
  std::sort(listed.begin(), listed.end());
  for (const auto& [tile, i] : listed) {
    if (works.empty() || works.back().tile != tile) works.push_back({tile, {}, {}});
    works.back().stamps.push_back(stamps_[i].get());
  }
  return works;
}

/// Makes all that the stamps need in the tile. False if there is no memory for it.
bool DetailStamp::prepare(TileWork& work) {
  DetailTile& tile = canvas_.at(work.tile);
  if (!tile.base_m || !(tile.depth_m || canvas_.make(tile.depth_m))) return false;
  work.channels = canvas_.complete_channels(work.tile);
  const bool opens =
      std::any_of(work.stamps.begin(), work.stamps.end(),
                  [&](const QueuedStamp* stamp) { return stamp->opens_in(tile.box); });
  if (opens && canvas_.layers() > 1) make_openable(tile.open, canvas_.layout());
  return true;
}

std::vector<DetailStamp::RowRange> DetailStamp::list_row_ranges(
    const std::vector<TileWork>& works) const {
  const DetailLayout& layout = canvas_.layout();
  const int rows = std::max(1, kBandRows / layout.factor());
  std::vector<RowRange> bands;
  for (const TileWork& work : works) {
    const CellBox box = layout.box(work.tile);
    for (int y = box.y0; y < box.y1; y += rows) {
      const int y1 = std::min(y + rows, box.y1);
      const bool touched =
          std::any_of(work.stamps.begin(), work.stamps.end(), [&](const QueuedStamp* stamp) {
            return stamp->blocks().y0 < y1 && stamp->blocks().y1 > y;
          });
      if (touched) bands.push_back({&work, y, y1});
    }
  }
  return bands;
}

void DetailStamp::finish() {
  if (used_ == 0) return;
  std::vector<TileWork> works = list_work();
  std::erase_if(works, [&](TileWork& work) { return !prepare(work); });
  std::vector<int> tiles;
  for (const TileWork& work : works) tiles.push_back(work.tile);
  canvas_.give_memory(tiles, threads_);
  const std::vector<RowRange> bands = list_row_ranges(works);
  threads_.for_ranges(0, static_cast<int>(bands.size()), 1, [&](int begin, int end) {
    StampRows band(canvas_, amount_);
    for (int i = begin; i < end; ++i) {
      const RowRange& part = bands[static_cast<std::size_t>(i)];
      band.begin(part.work->tile, part.work->channels, part.y0, part.y1);
      for (const QueuedStamp* stamp : part.work->stamps) band.apply(*stamp);
    }
  });
  used_ = 0;
}

}  // namespace pentimento
