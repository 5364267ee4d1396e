#pragma once
// Pictures that are stored turned or mirrored. Internal to formats.

#include "core/base/field.h"

namespace pentimento::image {

/// `stored` as it is to be looked at. `orientation` says where its first row and column belong, as
/// TIFF numbers it: 1 top, left; 2 top, right; 3 bottom, right; 4 bottom, left; 5 left, top;
/// 6 right, top; 7 right, bottom; 8 left, bottom. Other numbers mean 1. From 5 on width and height
/// change places.
Field<float> upright(Field<float> stored, int orientation);

}  // namespace pentimento::image
