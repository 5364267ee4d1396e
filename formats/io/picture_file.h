#pragma once
// A picture file being written, whatever its format.

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/shading/picture.h"

namespace pentimento {

using Provenance = std::vector<std::pair<std::string, std::string>>;  // key, value; UTF-8

/// A finished file: what it is called and the SHA-256 of its bytes.
struct Published {
  std::string file;
  std::string sha256;
  std::string temporary = {};  // where the bytes are until publish(); empty for streams
};

/// complete() makes the file whole under its temporary name (fsync, read back), and publish() gives
/// it its own name. So several files can be completed before the first is published. A file that is
/// destroyed without publish() leaves no trace.
class PictureFile : public PictureSink {
 public:
  virtual Result<Published> complete() = 0;
  virtual Result<void> publish() = 0;
  /// Does both.
  Result<Published> finish() {
    Result<Published> whole = complete();
    if (!whole) return whole;
    if (Result<void> published = publish(); !published) return published.error();
    return whole;
  }
};

}  // namespace pentimento
