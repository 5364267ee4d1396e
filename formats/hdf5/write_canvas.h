#pragma once
// Writes the planes of a canvas into a dump. For this folder only.

#include <hdf5.h>

#include <atomic>
#include <string>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento::hdf5 {

/// Writes the datasets of layout.h under `group` ("" for the root), whose groups fluid, canvas and
/// layers exist. `chunk_side`, `cancelled`: as in RowSource. False if HDF5 failed or the writing is
/// cancelled.
struct CanvasWriting {
  std::string group;
  std::uint64_t chunk_side = 0;
  int deflate_level = 1;
  const std::atomic<bool>* cancelled = nullptr;
};
bool write_canvas(hid_t file, const CanvasSource& canvas, const CanvasWriting& how,
                  const Threads& threads);

}  // namespace pentimento::hdf5
