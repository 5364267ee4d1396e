#pragma once
// A stroke of a sketch in space, before it is seen from somewhere. No behaviour.

#include <Eigen/Core>
#include <vector>

#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// The samples have all but their places; `stroke.width` is in the unit of the places, which are
/// right-handed, y up.
struct SpaceStroke {
  Stroke stroke;
  std::vector<Eigen::Vector3d> places;  // one for each sample
  bool twin = false;                    // the mirror image of the stroke before
};

}  // namespace pentimento::sketch
