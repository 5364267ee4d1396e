#pragma once
// What a finer canvas keeps beside its planes, in a state dump: the group /detail. For this folder
// only.

#include <hdf5.h>

#include <optional>

#include "core/base/result.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_notes.h"
#include "formats/hdf5/read_canvas.h"

namespace pentimento::hdf5 {

/// The guide that the canvas is `factor` times finer than.
struct NotedCanvas {
  const CanvasState& guide;
  int factor;
};

/// False if HDF5 failed.
bool write_notes(hid_t file, const DetailNotes& notes, const NotedCanvas& of, int deflate_level,
                 const Threads& threads);

/// Nothing if the dump has no such group. `from` is the whole file. Errors: kBadInput (a dataset
/// missing or of a wrong shape, a layer or cell that there is not, a hash that differs).
Result<std::optional<DetailNotes>> read_notes(const CanvasGroup& from, const NotedCanvas& of);

}  // namespace pentimento::hdf5
