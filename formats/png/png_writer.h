#pragma once
// Writes PNG: 8 or 16 bit RGB, in strips that several threads deflate, published atomically. It
// takes scene-linear strips (Rec. 709); this is the only place where colours are encoded. It can
// also write numbers that are no colours, as 16-bit codes of an even scale.

#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "formats/color/row_encoder.h"
#include "formats/io/picture_file.h"

namespace pentimento {

/// An even scale: value = offset + per_code * code, code 0..65535.
struct NumberScale {
  double offset = 0;
  double per_code = 1.0 / 65535;
  int channels = 1;  // 1: a grey picture, 3: red, green and blue
};

struct PngOptions {
  int width = 0, height = 0;
  int bit_depth = 8;      // 8 or 16
  double dpi = 0;         // 0: no pHYs chunk
  Provenance provenance;  // as iTXt/tEXt
  int threads = 1;
  bool no_clobber = false;
  ColorEncoding color = {};
  /// Set: the strips' first planes are numbers; `bit_depth` is 16, `color` is not used. Values
  /// beyond the scale are its ends.
  std::optional<NumberScale> numbers = std::nullopt;
};

/// `path` "-" is standard output. Errors: kIo.
Result<std::unique_ptr<PictureFile>> create_png(const std::string& path, const PngOptions& options);

}  // namespace pentimento
