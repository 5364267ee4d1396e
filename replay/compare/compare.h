#pragma once
// `pentimento compare`: two pictures or two state dumps.

#include <string>

#include "core/canvas_state.h"
#include "core/result.h"
#include "core/threads.h"
#include "formats/hdf5/state_dump.h"
#include "formats/image/read_image.h"
#include "replay/compare/comparison.h"

namespace pentimento {

/// Channel by channel, by name. Integer pictures are compared as stored (0..1, sRGB), float ones in
/// linear light; an integer with a float one in linear light. FLIP sees both as sRGB in 0..1.
Comparison compare_pictures(const Image& a, const Image& b, const Threads& threads);

/// Dataset by dataset, named as in the dump; parameters, palette and lighting that differ are
/// notes.
Comparison compare_states(const StateDump& a, const StateDump& b);

/// Reads both files (pictures or dumps, by content), compares and decides. Errors: what reading
/// gives; kBadInput for a picture against a dump.
Result<Comparison> compare_files(const std::string& a, const std::string& b,
                                 const CompareThresholds& thresholds, const Threads& threads);

}  // namespace pentimento
