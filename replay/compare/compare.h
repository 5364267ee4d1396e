#pragma once
// `pentimento compare`: two pictures or two state dumps.

#include <string>

#include "core/base/result.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/optics/channels.h"
#include "formats/hdf5/state_dump.h"
#include "formats/image/read_image.h"
#include "replay/compare/comparison.h"

namespace pentimento {

/// Channel by channel, by name. Integer pictures are compared as stored (0..1, encoded), float ones
/// in linear light; an integer with a float one in linear light. FLIP sees both as sRGB in 0..1.
/// Pictures of different profiles are compared as sRGB, with a note. The larger of two sizes of a
/// whole ratio is reduced by area means of linear light first.
Comparison compare_pictures(const Image& a, const Image& b, const Threads& threads);

/// Dataset by dataset, named as in the dump; parameters, palette and lighting that differ are
/// notes. Canvases of different sizes, one a whole multiple of the other, are compared by
/// compare_reduced. Errors: a detail canvas cannot be read.
Result<Comparison> compare_states(const StateDump& a, const StateDump& b, const Threads& threads);

/// How many times larger the second grid is, in both directions; 0 = not a whole number.
int whole_ratio(const CanvasGeometry& a, const CanvasGeometry& b);

/// Wet depth, dried paint, each pigment (per layer, then summed) and all pigment, the detail canvas
/// reduced by area means: fidelity() of each is added to `out`.
void compare_reduced(const CanvasSource& coarse, const CanvasSource& fine,
                     const ChannelBasis& basis, const Threads& threads, Comparison& out);

/// Reads both files (pictures or dumps, by content), compares and decides. Errors: what reading
/// gives; kBadInput for a picture against a dump.
Result<Comparison> compare_files(const std::string& a, const std::string& b,
                                 const CompareThresholds& thresholds, const Threads& threads);

}  // namespace pentimento
