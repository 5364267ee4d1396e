#pragma once
// Which tiles sleep, in a state dump: CanvasState::sleep as a table with a row per tile, y up. For
// this folder only.

#include <hdf5.h>

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "core/model/model.h"
#include "formats/hdf5/read_canvas.h"

namespace pentimento::hdf5 {

/// Name of the dataset within the group of its canvas.
inline constexpr const char* kSleepName = "/fluid/asleep";

/// Shape of the dataset: (tiles, values of a tile).
std::vector<std::uint64_t> sleep_shape(std::size_t values);

/// CanvasState::sleep in the form that the dump has.
std::vector<float> sleep_to_dump(const CanvasState& state);

/// Writes the dataset. If nothing sleeps, nothing is written: a dump without the dataset is all
/// awake.
bool write_sleep(hid_t file, const std::string& group, const CanvasState& state);

/// Fills `state.sleep`. `state` has its geometry already, in metres too; `model` is the dump's.
/// Errors: kBadInput (the number of rows is not that of the tiles that this model gives this
/// canvas, or a value is not finite).
Result<void> read_sleep(const CanvasGroup& from, const Model& model, CanvasState& state);

}  // namespace pentimento::hdf5
