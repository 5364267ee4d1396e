#include "formats/color/code_encoder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentimento {

CodeEncoder::CodeEncoder(ColorProfile profile, int max_code)
    : max_code_(max_code), threshold_(static_cast<std::size_t>(max_code) + 2) {
  threshold_[0] = 0;
  for (int c = 1; c <= max_code; ++c) {
    const double edge = decode_transfer(profile, (c - 0.5) / max_code);
    float t = static_cast<float>(edge);
    if (static_cast<double>(t) < edge) t = std::nextafterf(t, 2.0f);
    threshold_[static_cast<std::size_t>(c)] = t;
  }
  threshold_[static_cast<std::size_t>(max_code) + 1] = std::numeric_limits<float>::infinity();
  const std::uint32_t buckets = ((kOneBits - kFirstBits) >> kBucketShift) + 1;
  for (std::uint32_t i = 0; i < buckets; ++i) {
    const float low = std::bit_cast<float>(kFirstBits + (i << kBucketShift));
    const auto above = std::upper_bound(threshold_.begin(), threshold_.end(), low);
    start_.push_back(static_cast<std::uint32_t>(above - threshold_.begin()) - 1);
  }
}

}  // namespace pentimento
