#pragma once
// Provenance: what a file says about itself, ours or another program's, in PNG text chunks, EXR
// string attributes or HDF5 attributes. Only headers are read, never pixels.

#include <string>

#include "core/base/result.h"
#include "formats/io/picture_file.h"

namespace pentimento {

struct FileDescription {
  std::string format;  // "png", "exr", "hdf5"
  int width = 0;       // pixels, or cells of a state dump
  int height = 0;
  int bits = 0;           // per sample; 0 for a state dump
  double dpi = 0;         // 0 = not said
  std::string samples;    // "RGB 8 bit", "half: B G R", "2 layers x 5 channels"
  std::string profile;    // "Display P3"; of an EXR "Display P3 primaries"; empty = not said
  Provenance provenance;  // in the file's order
};

/// Errors: kIo, kBadInput (another kind of file, or a broken one).
Result<FileDescription> describe_file(const std::string& path);

/// The value of `key`, or empty.
std::string provenance_value(const Provenance& provenance, const std::string& key);

}  // namespace pentimento
