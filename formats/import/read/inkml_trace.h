#pragma once
// The points of an InkML trace: text to one number for each channel.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace pentimento::sketch {

/// What a trace's text needs to know of a channel.
struct InkmlChannel {
  std::string name;            // "X"
  double initial = 0;          // the value before the first one
  bool intermittent = false;   // may be left out at the end of a point
  double factor = 1;           // to metres, seconds, degrees; sign of the orientation included
  double least = 0, most = 0;  // of raw values; equal if not declared
  bool has_length = false;     // the factor leads to metres
};

/// The points of a trace, each with a raw value for every channel. Values are explicit (!), first
/// (') or second (") differences. Error: what is wrong, without the file's name.
Result<std::vector<std::vector<double>>> inkml_points(std::string_view text,
                                                      const std::vector<InkmlChannel>& channels);

}  // namespace pentimento::sketch
