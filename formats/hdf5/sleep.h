#pragma once
// What sleeps, in a state dump: CanvasState::sleep as a table of one row per tile, y up. For this
// folder only.

#include <hdf5.h>

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "core/model/model.h"
#include "formats/hdf5/read_canvas.h"

namespace pentimento::hdf5 {

/// Within the group of its canvas.
inline constexpr const char* kSleepName = "/fluid/asleep";

/// (tiles, values of a tile).
std::vector<std::uint64_t> sleep_shape(std::size_t values);

/// The values as the dump has them.
std::vector<float> sleep_to_dump(const CanvasState& state);

/// Nothing is written where nothing sleeps: an absent dataset means that all is awake.
bool write_sleep(hid_t file, const std::string& group, const CanvasState& state);

/// Fills `state.sleep`; `state` has its geometry, metres too, and `model` is the dump's.
/// Errors: kBadInput (not a row for each tile that this canvas has in this model, not finite).
Result<void> read_sleep(const CanvasGroup& from, const Model& model, CanvasState& state);

}  // namespace pentimento::hdf5
