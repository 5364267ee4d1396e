#pragma once
// Reads the canvas of a state dump: checks the shapes, then reads row by row. For this folder only.

#include <hdf5.h>

#include <atomic>
#include <string>

#include "core/base/interruption.h"
#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/rehearsal.h"

namespace pentimento::hdf5 {

/// A dump that is read: an open file, the file's name for messages, and what may end the reading.
struct DumpFile {
  hid_t file;
  const std::string& path;
  const Rehearsal& rehearsal;
  const std::atomic<bool>* cancelled;  // nullptr: nothing
  int threads = 1;
  /// Ok, or kInterrupted.
  Result<void> go_on() const { return unless_interrupted(cancelled); }
};

/// Where a canvas lies: the group that holds the canvas's groups, "" for the root.
struct CanvasGroup : DumpFile {
  std::string group;
};

/// The measures of the canvas, its datasets checked against each other and against the size of the
/// file. Errors: kBadInput (missing, must not be read, wrong rank, shapes that do not fit), kLimit
/// (beyond the limits).
struct ShapeLimits {
  std::uint64_t side, cells, values;
};
Result<CanvasShape> canvas_shape(const CanvasGroup& from, const ShapeLimits& limits);

/// A canvas with the shapes the file has, zero; its metres and step are left to the caller. At most
/// 65536 cells a side, 2^28 cells and 2^32 values. Errors: as canvas_shape.
Result<CanvasState> empty_canvas(const CanvasGroup& from);

/// Fills the dataset's planes. Errors: kBadInput (cannot be read, a value that is not finite or out
/// of range), kInterrupted.
Result<void> read_canvas(const CanvasGroup& from, const CanvasDataset& dataset, CanvasState& state);

/// A picture of linear light in a dump.
struct LightPicture {
  const char* name;
  std::uint64_t most_rows, most_columns, most_pixels;
};
/// Reads a (ny, nx, 3) dataset of floats into three planes. Errors: as read_canvas.
Result<std::array<Field<float>, 3>> read_rgb_planes(const DumpFile& from,
                                                    const LightPicture& picture);

}  // namespace pentimento::hdf5
