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

/// Compares two pictures channel by channel, by name. Two integer pictures are compared as stored
/// (0..1, encoded); if one of them is float, in linear light. FLIP sees both as sRGB in 0..1.
/// Pictures of different profiles are compared as sRGB, with a note. If one picture is a whole
/// number of times larger, it is reduced first, by area means of linear light.
Comparison compare_pictures(const Image& a, const Image& b, const Threads& threads);

/// Compares two dumps dataset by dataset, by the names in the dump. Differences of parameters,
/// palette and lighting become notes. Canvases of different sizes, one a whole multiple of the
/// other, are compared by compare_reduced. Errors: a detail canvas cannot be read.
Result<Comparison> compare_states(const StateDump& a, const StateDump& b, const Threads& threads);

/// How many times larger the second grid is, along both axes; 0 if that is not a whole number.
int whole_ratio(const CanvasGeometry& a, const CanvasGeometry& b);

/// Reduces `fine` by area means and compares it with `coarse`: wet depth, dried paint, each pigment
/// (layer by layer, then summed) and all pigment. Adds fidelity() of each to `out`.
void compare_reduced(const CanvasSource& coarse, const CanvasSource& fine,
                     const ChannelBasis& basis, const Threads& threads, Comparison& out);

/// Reads both files (pictures or dumps, by content), compares them and decides whether they are
/// equal, with `thread_count` threads (0: as many as the machine has). The threads start after the
/// files are read: reading a dump forks a child, and in a child of a process whose threads are just
/// starting the allocator of the address sanitizer may wait for ever. Errors: those of reading;
/// kBadInput for a picture and a dump.
Result<Comparison> compare_files(const std::string& a, const std::string& b,
                                 const CompareThresholds& thresholds, int thread_count);

}  // namespace pentimento
