#pragma once
// Converts a state from the channels of one palette to those of a larger palette. `--from` needs
// that when the log brings colours that the dump does not have.

#include <vector>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "core/optics/channels.h"

namespace pentimento {

/// Whether channel i of `basis` is the amount of pigment i, for every i.
bool channel_per_pigment(const ChannelBasis& basis);

/// `first`, followed by the pigments of `second` that have other names. Errors: kBadInput if one
/// name means two paints.
Result<std::vector<Pigment>> join_palettes(const std::vector<Pigment>& first,
                                           const std::vector<Pigment>& second);

/// Channels for `palette` that can hold a state with the channels `old`. They are one per pigment
/// only if `old` has one per pigment.
ChannelBasis channels_after(const ChannelBasis& old, const std::vector<Pigment>& palette);

/// The matrix from `old` to `basis`, which came from channels_after(). Row c: how much channel c of
/// `basis` gets per unit of each channel of `old`.
Eigen::MatrixXf channel_conversion(const ChannelBasis& old, const ChannelBasis& basis);

/// The same paint in the channels of `basis`, which came from channels_after(): pigments keep their
/// planes, or become amounts of absorption and scattering.
CanvasState change_channels(CanvasState state, const ChannelBasis& old, const ChannelBasis& basis);

}  // namespace pentimento
