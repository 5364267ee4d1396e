#include "formats/color/code_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr std::size_t kLookedUp = 64;  // values together

/// Two neighbours in a table, which are read as one.
template <typename T>
struct Neighbours {
  T here, next;
};

template <typename T>
void look_up(const T* table, const std::uint32_t* at, int n, Neighbours<T>* found) {
  for (int i = 0; i < n; ++i) std::memcpy(&found[i], table + at[i], sizeof(found[i]));
}

/// The bucket of each value, and how far it lies within it. `last_bits`: of the largest value that
/// has a bucket. A value beyond the buckets, or NaN, counts as the next that has one.
PENTIMENTO_KERNEL
void find_buckets(std::uint32_t first_bits, std::uint32_t last_bits, int shift, const float* v,
                  int n, std::uint32_t* __restrict bucket, std::uint32_t* __restrict within) {
  const float least = std::bit_cast<float>(first_bits), most = std::bit_cast<float>(last_bits);
  for (int i = 0; i < n; ++i) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::min(std::max(least, v[i]), most));
    bucket[i] = (bits - first_bits) >> shift;
    within[i] = bits & ((1u << shift) - 1);
  }
}

/// About the code of each value.
PENTIMENTO_KERNEL
void guess_codes(const Neighbours<std::uint32_t>* start, const std::uint32_t* within, int shift,
                 int part_shift, int n, std::uint32_t* __restrict code) {
  for (int i = 0; i < n; ++i) {
    const std::uint32_t width = start[i].next - start[i].here;
    code[i] = (start[i].here + ((width * (within[i] >> 4)) >> (shift - 4))) >> part_shift;
  }
}

/// The codes of values of at least 1, and of those that lie between the edges of the guessed code.
/// Others become -1. False if there are any.
PENTIMENTO_KERNEL
bool keep_guesses(const float* v, const Neighbours<float>* edge, const std::uint32_t* guess,
                  int max_code, int n, int* __restrict code) {
  int any = 0;
  for (int i = 0; i < n; ++i) {
    const int inside = (v[i] >= edge[i].here ? 1 : 0) & (v[i] < edge[i].next ? 1 : 0);
    const int here = inside != 0 ? static_cast<int>(guess[i]) : -1;
    code[i] = v[i] >= 1 ? max_code : here;
    any |= code[i];
  }
  return any >= 0;
}
}  // namespace

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
    const auto code = static_cast<std::uint32_t>(above - threshold_.begin()) - 1;
    const float share = (low - threshold_[code]) / (*above - threshold_[code]);
    start_.push_back((code << kPartShift) + static_cast<std::uint32_t>(share * (1 << kPartShift)));
  }
}

void CodeEncoder::encode_row(const float* v, int n, int* code) const {
  std::array<std::uint32_t, kLookedUp> bucket, within, guess;
  std::array<Neighbours<std::uint32_t>, kLookedUp> start;
  std::array<Neighbours<float>, kLookedUp> edge;
  for (int done = 0; done < n;
       done += static_cast<int>(kLookedUp), v += kLookedUp, code += kLookedUp) {
    const int count = std::min(static_cast<int>(kLookedUp), n - done);
    find_buckets(kFirstBits, kOneBits - 1, kBucketShift, v, count, bucket.data(), within.data());
    look_up(start_.data(), bucket.data(), count, start.data());
    guess_codes(start.data(), within.data(), kBucketShift, kPartShift, count, guess.data());
    look_up(threshold_.data(), guess.data(), count, edge.data());
    if (keep_guesses(v, edge.data(), guess.data(), max_code_, count, code)) continue;
    for (int i = 0; i < count; ++i)
      if (code[i] < 0) code[i] = encode(v[i]);
  }
}

}  // namespace pentimento
