#pragma once
// The colour spaces of FLIP: opponent YCxCz for filtering, Hunt-adjusted CIELAB for differences.
// White is that of D65, so linear (1,1,1) is Y = 100, Cx = Cz = 0 and L = 100.

#include <array>

namespace pentimento::flip {

using Color = std::array<double, 3>;

/// Linear Rec. 709 to YCxCz and back.
Color ycxcz_of_rgb(const Color& rgb);
Color rgb_of_ycxcz(const Color& ycc);
/// CIELAB, its a and b scaled by 0.01 L: colours are seen less in the dark (Hunt).
Color hunt_lab_of_rgb(const Color& rgb);
/// Difference in lightness plus distance in colour (Abasi, Amani Tehran and Fairchild 2020).
double hyab(const Color& a, const Color& b);

}  // namespace pentimento::flip
