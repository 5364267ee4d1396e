#pragma once
// The bounds of a number in a log. The bounds themselves are allowed.

#include <string_view>

namespace pentimento::log {

struct Range {
  double min, max;
  std::string_view unit = {};
};

}  // namespace pentimento::log
