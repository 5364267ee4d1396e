#pragma once
// A state whose channels meant one palette, told in the channels of a larger one: what `--from`
// needs when the log brings colours that the dump does not have.

#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "core/optics/channels.h"

namespace pentimento {

/// Whether channel i of `basis` is the amount of pigment i, for every i.
bool channel_per_pigment(const ChannelBasis& basis);

/// `first` and what `second` has under other names. Errors: kBadInput where one name means two
/// paints.
Result<std::vector<Pigment>> join_palettes(const std::vector<Pigment>& first,
                                           const std::vector<Pigment>& second);

/// Channels for `palette` in which a state with channels `old` can be told: one per pigment only if
/// that is what `old` has.
ChannelBasis channels_after(const ChannelBasis& old, const std::vector<Pigment>& palette);

/// Row c: what channel c of `basis`, which came from channels_after(), has per unit of each channel
/// of `old`.
Eigen::MatrixXf channel_conversion(const ChannelBasis& old, const ChannelBasis& basis);

/// The same paint in the channels of `basis`, which came from channels_after(): pigments keep their
/// planes, or become amounts of absorption and scattering.
CanvasState change_channels(CanvasState state, const ChannelBasis& old, const ChannelBasis& basis);

}  // namespace pentimento
