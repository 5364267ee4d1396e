#pragma once
// The order in which sweeps over the rows of a canvas are done.

#include <functional>

#include "core/base/threads.h"

namespace pentimento::paper {

/// Calls row(sweep, y) for `sweeps` sweeps over the rows [begin, end), so that a row comes when the
/// sweep before has done it and the rows beside it, and nobody needs any more what it had two
/// sweeps before: two buffers in turn do, as if each sweep were done as a whole. But a row is swept
/// again while what it is computed from is still in the processor's cache, and whole canvases are
/// read once for all sweeps. Blocks of rows are done side by side.
/// What is done before or after the sweeps (traces, systems, limits) may be sweeps of their own:
/// each may read of the one before the row and those beside it, and of earlier ones the row alone.
/// Each block does of sweep s what needs no other block, s rows less at either end. Then what is
/// missing around each border is done. Source: split tiling (Grosser et al., Split tiling for GPUs,
/// GPGPU-6, 2013).
void for_sweeps(const Threads& threads, int begin, int end, int sweeps,
                const std::function<void(int sweep, int y)>& row);

}  // namespace pentimento::paper
