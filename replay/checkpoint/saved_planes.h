#pragma once
// The planes of the detail canvas in the files of a checkpoint: each save appends those that
// changed.

#include <cstdint>
#include <set>
#include <string>

#include "core/base/result.h"
#include "core/detail/detail_follower.h"
#include "formats/checkpoint/detail_part.h"
#include "formats/checkpoint/plane_index.h"

namespace pentimento {

class SavedPlanes {
 public:
  explicit SavedPlanes(std::string folder) : folder_(std::move(folder)) {}

  /// Brings the planes that `index` lists to `follower`, whose other notes are `notes` and whose
  /// guide is `guide`. Errors: those of PlaneFiles::read() and of the canvas.
  Result<void> recall(const checkpoint::DetailNotes& notes, checkpoint::PlaneIndex index,
                      const CanvasState& guide, DetailFollower& follower);
  /// Writes what changed since the last committed save into the file of `generation`. Returns the
  /// index of all planes. Errors: kIo.
  Result<checkpoint::PlaneIndex> save(const DetailFollower& follower, std::uint64_t generation);
  /// The slot with that index is whole.
  void commit(checkpoint::PlaneIndex index, DetailFollower& follower);

  /// Of the last slot.
  const checkpoint::PlaneIndex& index() const { return index_; }
  /// How many bytes save() would write.
  std::int64_t bytes_to_save(const DetailFollower& follower) const;
  /// How many it wrote last.
  std::int64_t bytes_saved() const { return bytes_saved_; }

 private:
  bool wastes_disk(const DetailCanvas& canvas) const;

  std::string folder_;
  checkpoint::PlaneIndex index_;
  std::int64_t bytes_saved_ = 0;
};

}  // namespace pentimento
