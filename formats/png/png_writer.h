#pragma once
// PNG out: 8 or 16 bit RGB, streamed in strips deflated by several threads, published atomically.
// Takes scene-linear strips (Rec. 709) and encodes the profile's colours once, here.

#include <memory>
#include <string>

#include "core/result.h"
#include "formats/color/row_encoder.h"
#include "formats/io/picture_file.h"

namespace pentimento {

struct PngOptions {
  int width = 0, height = 0;
  int bit_depth = 8;      // 8 or 16
  double dpi = 0;         // 0: no pHYs chunk
  Provenance provenance;  // as iTXt/tEXt
  int threads = 1;
  bool no_clobber = false;
  ColorEncoding color;
};

/// `path` "-" is standard output. Errors: kIo.
Result<std::unique_ptr<PictureFile>> create_png(const std::string& path, const PngOptions& options);

}  // namespace pentimento
