#pragma once
// The wet paint of the detail canvas dries (R20).

#include "core/base/threads.h"
#include "core/detail/store/detail_canvas.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

/// Per fine cell what dry_canvas() does per cell of the guide: b += d, the reflectance becomes that
/// of the wet layers over it; the wet planes of all tiles are freed.
void dry_detail(DetailCanvas& canvas, const ChannelBasis& basis, const Model& model,
                const Threads& threads);

}  // namespace pentimento
