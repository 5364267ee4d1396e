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

DetailStamp::~DetailStamp() {
  try {
    threads_.withdraw();
  } catch (...) {  // whoever needs the stamps has asked for them, and heard of it
  }
}

void DetailStamp::begin() {
  if (filling().used == kMostWaiting) start();
  Batch& batch = filling();
  if (batch.used == batch.stamps.size())
    batch.stamps.push_back(std::make_unique<QueuedStamp>(canvas_.channels()));
  ++batch.used;
}

void DetailStamp::before_deposit(const StampPlan& plan, const CanvasState& guide) {
  last().before_deposit(plan, guide, canvas_.layout(), amount_);
}

void DetailStamp::add_touched(ChangedBlocks& blocks) {
  QueuedStamp& stamp = last();
  stamp.find_touched(canvas_.layout());
  for (int y = stamp.blocks().y0; y < stamp.blocks().y1; ++y) {
    const QueuedStamp::BlockSpan touched = stamp.touched_blocks(y, canvas_.layout());
    blocks.add(y, touched.x0, touched.x1);
  }
}

void DetailStamp::after_deposit(const StampPlan& plan, const CanvasState& guide) {
  QueuedStamp& stamp = last();
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

void DetailStamp::list_work(Batch& batch) const {
  batch.works.clear();
  std::vector<std::pair<int, std::size_t>> listed;  // tile, stamp
  for (std::size_t i = 0; i < batch.used; ++i)
    for_tiles(batch.stamps[i]->blocks(), [&](int tile) { listed.emplace_back(tile, i); });
  std::sort(listed.begin(), listed.end());
  for (const auto& [tile, i] : listed) {
    if (batch.works.empty() || batch.works.back().tile != tile)
      batch.works.push_back({tile, {}, {}});
    batch.works.back().stamps.push_back(batch.stamps[i].get());
  }
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

void DetailStamp::list_bands(Batch& batch) const {
  const DetailLayout& layout = canvas_.layout();
  const int rows = std::max(1, kBandRows / layout.factor());
  for (const TileWork& work : batch.works) {
    const CellBox box = layout.box(work.tile);
    for (int y = box.y0; y < box.y1; y += rows) {
      const int y1 = std::min(y + rows, box.y1);
      const bool touched =
          std::any_of(work.stamps.begin(), work.stamps.end(), [&](const QueuedStamp* stamp) {
            return stamp->blocks().y0 < y1 && stamp->blocks().y1 > y;
          });
      if (touched) batch.bands.emplace_back(&work, y, y1);
    }
  }
}

/// Does those of the bands [begin, end) that nobody has taken.
void DetailStamp::do_bands(Batch& batch, std::size_t begin, std::size_t end) {
  StampRows rows(canvas_, amount_);
  for (std::size_t i = begin; i < end; ++i) {
    StampedRows& band = batch.bands[i];
    if (band.taken.exchange(true)) continue;
    rows.begin(band.work->tile, band.work->channels, band.y0, band.y1);
    for (const QueuedStamp* stamp : band.work->stamps) rows.apply(*stamp);
  }
}

/// False if all bands are taken.
bool DetailStamp::do_next_band() {
  Batch& batch = begun();
  const std::size_t i = batch.next.fetch_add(1);
  if (i >= batch.bands.size()) return false;
  do_bands(batch, i, i + 1);
  return true;
}

void DetailStamp::start() {
  // The stamps before these come first.
  finish_begun();
  Batch& batch = filling();
  if (batch.used == 0) return;
  filling_ = 1 - filling_;
  // All that the stamps need is made now, for the work itself makes nothing.
  list_work(batch);
  std::erase_if(batch.works, [&](TileWork& work) { return !prepare(work); });
  std::vector<int> tiles;
  for (const TileWork& work : batch.works) tiles.push_back(work.tile);
  canvas_.give_memory(tiles, threads_);
  list_bands(batch);
  threads_.offer(next_band_);
}

/// All threads do what is left of the stamps that have begun.
void DetailStamp::finish_begun() {
  Batch& batch = begun();
  threads_.for_ranges(0, static_cast<int>(batch.bands.size()), 1, [&](int first, int end) {
    do_bands(batch, static_cast<std::size_t>(first), static_cast<std::size_t>(end));
  });
  threads_.withdraw();
  batch.bands.clear();
  batch.next = 0;
  batch.used = 0;
}

void DetailStamp::finish() {
  start();
  finish_begun();
}

void DetailStamp::forget() {
  finish_begun();
  filling().used = 0;
}

}  // namespace pentimento
