#pragma once
// The colour spaces of FLIP: opponent YCxCz for filtering, Hunt-adjusted CIELAB for differences.
// White is that of D65, so linear (1,1,1) is Y = 100, Cx = Cz = 0 and L = 100.

#include <array>

namespace pentimento::flip {

using ColorTriple = std::array<double, 3>;

/// Linear Rec. 709 to YCxCz and back.
ColorTriple ycxcz_of_rgb(const ColorTriple& rgb);
ColorTriple rgb_of_ycxcz(const ColorTriple& ycc);
/// CIELAB, its a and b scaled by 0.01 L: colours are seen less in the dark (Hunt).
ColorTriple hunt_lab_of_rgb(const ColorTriple& rgb);
/// Difference in lightness plus distance in colour (Abasi, Amani Tehran and Fairchild 2020).
double hyab(const ColorTriple& a, const ColorTriple& b);

}  // namespace pentimento::flip
