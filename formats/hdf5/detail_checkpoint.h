#pragma once
// The checkpoint of the detail canvas in a state dump: the group /detail. For this folder only.

#include <hdf5.h>

#include <optional>

#include "core/base/result.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_checkpoint.h"
#include "formats/hdf5/read_canvas.h"

namespace pentimento::hdf5 {

/// The detail canvas of a checkpoint: its guide, and how many times finer it is.
struct CheckpointedCanvas {
  const CanvasState& guide;
  int factor;
};

/// False if HDF5 failed.
bool write_checkpoint(hid_t file, const DetailCheckpoint& checkpoint, const CheckpointedCanvas& of,
                      int deflate_level, const Threads& threads);

/// Reads a checkpoint; nullopt if the dump has no group /detail. `from` is the whole file. Errors:
/// kBadInput (a dataset that is missing or of a wrong shape, a layer or cell that does not exist, a
/// hash that differs).
Result<std::optional<DetailCheckpoint>> read_checkpoint(const CanvasGroup& from,
                                                        const CheckpointedCanvas& of);

}  // namespace pentimento::hdf5
