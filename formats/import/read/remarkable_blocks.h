#pragma once
// Version 6 of reMarkable's files: blocks of tagged values (github.com/ricklupton/rmscene).

#include "core/base/result.h"
#include "formats/import/sketch/byte_reader.h"
#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// Strokes in the order of painting, group by group; `layer` is the group's number.
struct RemarkableScene {
  std::vector<Stroke> strokes;
  double width_px = 1404, height_px = 1872;  // of the page; x counts from its middle
  int deleted = 0;                           // lines that are not there any more
};

/// Reads all blocks to the end. Errors: kBadInput "file: offset N: what".
Result<RemarkableScene> read_remarkable_blocks(ByteReader& in);

}  // namespace pentimento::sketch
