#pragma once
// A picture file being written, whatever its format.

#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/shading/picture.h"

namespace pentimento {

using Provenance = std::vector<std::pair<std::string, std::string>>;  // key, value; UTF-8

/// A finished file: what it is called and the SHA-256 of its bytes.
struct Published {
  std::string file;
  std::string sha256;
};

/// finish() publishes it (temporary, fsync, read back, rename); destruction without it leaves no
/// trace.
class PictureFile : public PictureSink {
 public:
  virtual Result<Published> finish() = 0;
};

}  // namespace pentimento
