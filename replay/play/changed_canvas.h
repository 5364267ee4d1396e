#pragma once
// change_channels() for a detail canvas that is read part by part.

#include <memory>

#include "core/canvas/canvas_source.h"
#include "core/detail/store/detail_checkpoint.h"
#include "core/optics/channels.h"
#include "formats/hdf5/state_dump.h"

namespace pentimento {

/// The same paint in the channels of `basis`, which came from channels_after(). Values are
/// converted when they are read.
std::shared_ptr<const CanvasSource> change_channels(std::shared_ptr<const CanvasSource> canvas,
                                                    const ChannelBasis& old,
                                                    const ChannelBasis& basis);

/// The checkpoint for that canvas. `checkpoint` has the layers and the basis of `dump`.
DetailCheckpoint change_channels(DetailCheckpoint checkpoint, const StateDump& dump,
                                 const ChannelBasis& basis);

}  // namespace pentimento
