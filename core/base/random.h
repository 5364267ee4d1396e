#pragma once
// Random numbers without a shared generator. Each number is a function of its purpose, of the
// stroke and of a counter, so neither the order of drawing nor threads nor stops can change it. The
// mixing function is SplitMix64's (Steele, Lea, Flood, Fast Splittable Pseudorandom Number
// Generators, OOPSLA 2014; constants of Stafford's variant 13 as in Vigna's public reference).

#include <cstdint>

namespace pentimento {

/// What a number is for; numbers of different purposes are independent. The values are part of the
/// state's definition: never renumber, only add.
enum class RandomPurpose : std::uint64_t {
  kPaperRelief = 1,
  kTipTexture = 2,
  kBristle = 3,
  kStampJitter = 4,
};

namespace random_detail {
inline constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15ULL;
constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}
}  // namespace random_detail

/// The n-th number (n >= 1) of SplitMix64 started at `seed`.
constexpr std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t n) {
  return random_detail::mix(seed + n * random_detail::kGoldenGamma);
}

/// 64 random bits for (purpose, stroke, counter).
constexpr std::uint64_t random_bits(RandomPurpose purpose, std::uint64_t stroke,
                                    std::uint64_t counter) {
  const std::uint64_t by_purpose = splitmix64(static_cast<std::uint64_t>(purpose), 1);
  const std::uint64_t by_stroke = splitmix64(by_purpose ^ stroke, 1);
  return splitmix64(by_stroke, counter + 1);
}

/// Uniform in [0, 1): one of the 2^24 multiples of 2^-24, exactly.
constexpr float random_uniform(RandomPurpose purpose, std::uint64_t stroke, std::uint64_t counter) {
  return static_cast<float>(random_bits(purpose, stroke, counter) >> 40) * 0x1p-24f;
}

}  // namespace pentimento
