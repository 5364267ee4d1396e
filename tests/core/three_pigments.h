#pragma once
// The palette of small test paintings.

#include <vector>

#include "core/optics/paints/pigment_library.h"

namespace pentimento::test {

inline std::vector<Pigment> three_pigments() {
  std::vector<Pigment> palette;
  for (const char* name : {"Ultramarine Blue", "Vermilion", "Titanium White"})
    palette.push_back(*find_library_pigment(name));
  return palette;
}

}  // namespace pentimento::test
