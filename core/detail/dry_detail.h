#pragma once
// The wet paint of the detail canvas dries (R20).

#include "core/base/threads.h"
#include "core/detail/store/detail_canvas.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

/// Does in each fine cell what dry_canvas() does in each cell of the guide: b += d, and the
/// reflectance becomes that of the wet layers over it. Then it frees the wet planes of all tiles.
void dry_detail(DetailCanvas& canvas, const ChannelBasis& basis, const Model& model,
                const Threads& threads);

}  // namespace pentimento
