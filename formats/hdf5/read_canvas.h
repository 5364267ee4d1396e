#pragma once
// The canvas of a state dump: shapes checked, then read row by row. For this folder only.

#include <hdf5.h>

#include <string>

#include "core/canvas_state.h"
#include "core/result.h"
#include "formats/hdf5/layout.h"

namespace pentimento::hdf5 {

/// Largest canvas that is read: cells of a plane, and values in all.
inline constexpr std::uint64_t kMostCells = std::uint64_t{1} << 28;
inline constexpr std::uint64_t kMostValues = std::uint64_t{1} << 32;

/// A canvas with the shapes the file has, zero; its metres and step are left to the caller.
/// Errors: kBadInput (missing, wrong rank, shapes that do not fit each other), kLimit.
Result<CanvasState> empty_canvas(hid_t file, const std::string& path);

/// Fills the dataset's planes. Errors: kBadInput (cannot be read, a value that is not finite).
Result<void> read_canvas(hid_t file, const std::string& path, const CanvasDataset& dataset,
                         CanvasState& state);

/// Rows of a (ny, nx, 3) dataset of float into three planes.
Result<std::array<Field<float>, 3>> read_rgb_planes(hid_t file, const std::string& path,
                                                    const std::string& name);

}  // namespace pentimento::hdf5
