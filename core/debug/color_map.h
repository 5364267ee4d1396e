#pragma once
// Colour maps: numbers as colours, for pictures that show a plane and not a painting.

#include <array>
#include <cstdint>
#include <span>

namespace pentimento {

/// An sRGB colour, 8 bits a channel.
using Code8 = std::array<std::uint8_t, 3>;
/// Linear light, Rec. 709.
using Linear3 = std::array<float, 3>;

Linear3 linear_of(const Code8& code);

/// The nodes of a colour map: evenly spaced colours, with straight lines between them in sRGB
/// codes, so that the map gives each node to the bit.
using ColorNodes = std::span<const Code8>;

/// The colour at `t` in 0..1 (values outside are the ends'). Needs at least two nodes.
Linear3 color_at(ColorNodes nodes, double t);

/// Dark violet to yellow, evenly bright steps: "viridis" of van der Walt and Smith (CC0).
ColorNodes viridis();
/// Black to pale yellow through violet: "magma", likewise.
ColorNodes magma();
/// Pale to deep blue: "Blues" of ColorBrewer (Brewer, Harrower; Apache 2.0).
ColorNodes blues();

/// A full hue at `turn` of the colour circle (0 red, 1/3 green, 2/3 blue), `share` of it over
/// `ground`.
Linear3 hue_over(const Code8& ground, double turn, double share);

}  // namespace pentimento
