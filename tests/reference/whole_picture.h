#pragma once
// A sink that keeps every plane whole, for tests.

#include <algorithm>
#include <map>
#include <string>

#include "core/shading/shader.h"

namespace pentimento::reference {

class WholePicture : public PictureSink {
 public:
  Result<void> write(const PictureStrip& strip) override {
    in_order = in_order && strip.y0 == rows;
    rows += strip.rows;
    ++strips;
    for (std::size_t i = 0; i < strip.name.size(); ++i) {
      std::vector<float>& plane = planes[strip.name[i]];
      width = strip.plane[i].width();
      for (int y = 0; y < strip.rows; ++y) {
        const auto row = strip.plane[i].row_span(y);
        plane.insert(plane.end(), row.begin(), row.end());
      }
    }
    return {};
  }
  float at(const std::string& name, int x, int y) const {
    return planes.at(name)[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x)];
  }

  std::map<std::string, std::vector<float>> planes;
  int width = 0;
  int rows = 0;
  int strips = 0;
  bool in_order = true;
};

}  // namespace pentimento::reference
