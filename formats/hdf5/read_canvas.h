#pragma once
// Reads the canvas of a state dump: checks the shapes, then reads row by row. For this folder only.

#include <hdf5.h>

#include <string>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "formats/hdf5/layout.h"

namespace pentimento::hdf5 {

/// Where a canvas lies: an open file, the file's name for messages, and the group that holds the
/// canvas's groups, "" for the root.
struct CanvasGroup {
  hid_t file;
  const std::string& path;
  std::string group;
};

/// The measures of the canvas, its datasets checked against each other. Errors: kBadInput (missing,
/// wrong rank, shapes that do not fit), kLimit (beyond the limits).
struct ShapeLimits {
  std::uint64_t side, cells, values;
};
Result<CanvasShape> canvas_shape(const CanvasGroup& from, const ShapeLimits& limits);

/// A canvas with the shapes the file has, zero; its metres and step are left to the caller. At most
/// 65536 cells a side, 2^28 cells and 2^32 values. Errors: as canvas_shape.
Result<CanvasState> empty_canvas(const CanvasGroup& from);

/// Fills the dataset's planes. Errors: kBadInput (cannot be read, a value that is not finite).
Result<void> read_canvas(const CanvasGroup& from, const CanvasDataset& dataset, CanvasState& state);

/// Reads a (ny, nx, 3) dataset of floats into three planes.
Result<std::array<Field<float>, 3>> read_rgb_planes(hid_t file, const std::string& path,
                                                    const std::string& name);

}  // namespace pentimento::hdf5
