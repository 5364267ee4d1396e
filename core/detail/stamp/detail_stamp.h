#pragma once
// The guide's stamps on the detail canvas. The plans are the same; a dozen stamps are queued and
// then done together, tile by tile, while a tile is in the cache and while the guide goes on. What
// a stamp does to a cell depends on that cell alone, so the order of the cells is free.

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/detail/stamp/queued_stamp.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

class DetailStamp {
 public:
  /// All references must outlive the object; `amount` as in LayerRow.
  DetailStamp(DetailCanvas& canvas, std::span<const float> amount, const Threads& threads);
  ~DetailStamp();
  DetailStamp(const DetailStamp&) = delete;
  DetailStamp& operator=(const DetailStamp&) = delete;

  /// Makes room for a stamp in the queue. If it is full, begins to do what is in it.
  void begin();
  /// Draws the tip of the stamp for which there is room now. It may be called beside the next two.
  void draw_tip(const StampPlan& plan) { last().draw_tip(plan, canvas_.layout()); }
  /// Queues the stamp. The guide has just picked up paint and not deposited any yet.
  void before_deposit(const StampPlan& plan, const CanvasState& guide);
  /// The guide has deposited. Makes planes for the paint that came.
  void after_deposit(const StampPlan& plan, const CanvasState& guide);
  /// Begins to do all queued stamps: threads that have nothing else to do do them. Until finish()
  /// nobody else may touch the cells of the canvas; planes may be made.
  void start();
  /// Does all queued stamps.
  void finish();
  /// Drops all queued stamps that have not begun.
  void forget();
  /// Cells of the guide under the last stamp.
  const CellBox& box() const { return last().blocks(); }
  /// Finds which cells the last stamp's tip touches, and adds their blocks. Its tip must have been
  /// drawn.
  void add_touched(ChangedBlocks& blocks);

 private:
  /// The stamps that touch a tile.
  struct TileWork {
    int tile = 0;
    std::vector<int> channels;  // of which the tile has planes
    std::vector<const QueuedStamp*> stamps;
  };
  /// Rows of blocks [y0, y1) of a tile. Whoever sets `taken` does them.
  struct StampedRows {
    StampedRows(const TileWork* band_of, int first, int end) : work(band_of), y0(first), y1(end) {}
    const TileWork* work;
    int y0, y1;
    std::atomic<bool> taken{false};
  };
  /// Stamps that are done together; the first `used` are queued.
  struct Batch {
    std::vector<std::unique_ptr<QueuedStamp>> stamps;
    std::size_t used = 0;
    std::vector<TileWork> works;  // once it has begun
    std::deque<StampedRows> bands;
    std::atomic<std::size_t> next{0};  // bands before it are taken
  };
  Batch& filling() { return batches_[filling_]; }
  Batch& begun() { return batches_[1 - filling_]; }
  QueuedStamp& last() const {
    const Batch& batch = batches_[filling_];
    return *batch.stamps[batch.used - 1];
  }
  template <typename Body>
  void for_tiles(const CellBox& blocks, const Body& body) const;
  void list_work(Batch& batch) const;
  bool prepare(TileWork& work);
  void list_bands(Batch& batch) const;
  bool do_next_band();
  void do_bands(Batch& batch, std::size_t begin, std::size_t end);
  void finish_begun();

  DetailCanvas& canvas_;
  std::vector<float> amount_;
  const Threads& threads_;
  std::array<Batch, 2> batches_;
  std::size_t filling_ = 0;  // which of them is queued; the other has begun, or is empty
  const std::function<bool()> next_band_ = [this] { return do_next_band(); };
};

}  // namespace pentimento
