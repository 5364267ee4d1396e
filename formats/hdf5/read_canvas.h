#pragma once
// The canvas of a state dump: shapes checked, then read row by row. For this folder only.

#include <hdf5.h>

#include <string>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "formats/hdf5/layout.h"

namespace pentimento::hdf5 {

/// Where a canvas is: an open file, what it is called, and "" or the group that its groups are in.
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

/// Rows of a (ny, nx, 3) dataset of float into three planes.
Result<std::array<Field<float>, 3>> read_rgb_planes(hid_t file, const std::string& path,
                                                    const std::string& name);

}  // namespace pentimento::hdf5
