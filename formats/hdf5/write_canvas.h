#pragma once
// Writes the planes of a canvas into a dump. For this folder only.

#include <hdf5.h>

#include <string>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento::hdf5 {

/// Writes the datasets of layout.h under `group` ("" for the root), whose groups fluid, canvas and
/// layers exist. `chunk_side`: as in RowSource. False if HDF5 failed.
struct CanvasWriting {
  std::string group;
  std::uint64_t chunk_side = 0;
  int deflate_level = 1;
};
bool write_canvas(hid_t file, const CanvasSource& canvas, const CanvasWriting& how,
                  const Threads& threads);

}  // namespace pentimento::hdf5
