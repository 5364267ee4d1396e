#pragma once
// Elementary functions for everything that reaches the state. One C library may round exp, log or
// sin differently from another. The functions here use only + - * / and comparisons, so every IEEE
// machine gives the same bits. Sources: Cody and Waite, Software Manual for the Elementary
// Functions, 1980 (argument reduction with a split constant); the polynomials are Taylor series
// that are long enough for the reduced range. The float versions round the double result.
//
// Largest errors, tested against the C library: exp, expm1, exp2, log, log1p, log2, tanh, sinh,
// cosh, atan2 <= 4 ulp; sin and cos <= 3e-16 absolute for |x| <= 1e6; pow <= 1e-15 (1 + |y ln x|)
// relative; the float versions <= 1 ulp. NaN gives NaN.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace pentimento::approx {

namespace detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kLn2 = 0.693147180559945309417;
inline constexpr double kLn2High = 6.93147180369123816490e-01;  // 32 bits: k * this is exact
inline constexpr double kLn2Low = 1.90821492927058770002e-10;
inline constexpr double kHalfPi = 1.57079632679489661923;
inline constexpr double kPi = 3.14159265358979323846;

/// c[0] + c[1] x + c[2] x^2 + ... by Horner's rule.
template <std::size_t N>
constexpr double polynomial(const std::array<double, N>& c, double x) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// Nearest integer, |x| < 2^31; halves away from zero.
constexpr int nearest(double x) {
  return static_cast<int>(x + (x < 0 ? -0.5 : 0.5));
}

/// 2^k for k in [-1022, 1023].
constexpr double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

/// x 2^k, by two factors, so that a subnormal result is rounded only once.
constexpr double scaled(double x, int k) {
  const int half = k / 2;
  return x * power_of_two(half) * power_of_two(k - half);
}

/// e^r - 1 for |r| <= 0.36.
constexpr double small_expm1(double r) {
  constexpr std::array<double, 13> kInverseFactorial = {1.0,
                                                        1.0 / 2,
                                                        1.0 / 6,
                                                        1.0 / 24,
                                                        1.0 / 120,
                                                        1.0 / 720,
                                                        1.0 / 5040,
                                                        1.0 / 40320,
                                                        1.0 / 362880,
                                                        1.0 / 3628800,
                                                        1.0 / 39916800,
                                                        1.0 / 479001600,
                                                        1.0 / 6227020800.0};
  return r * polynomial(kInverseFactorial, r);
}

/// 2 atanh(s) = ln((1 + s) / (1 - s)) for |s| <= 0.172.
constexpr double twice_atanh(double s) {
  constexpr std::array<double, 11> kOdd = {2.0,      2.0 / 3,  2.0 / 5,  2.0 / 7,
                                           2.0 / 9,  2.0 / 11, 2.0 / 13, 2.0 / 15,
                                           2.0 / 17, 2.0 / 19, 2.0 / 21};
  return s * polynomial(kOdd, s * s);
}

/// x = mantissa * 2^exponent with mantissa in [sqrt(1/2), sqrt(2)); x positive and finite.
struct Split {
  double mantissa;
  int exponent;
};
constexpr Split split(double x) {
  constexpr double kSqrt2 = 1.41421356237309504880;
  constexpr double kSmallestNormal = std::numeric_limits<double>::min();
  const int lift = x < kSmallestNormal ? 54 : 0;
  const auto bits = std::bit_cast<std::uint64_t>(lift != 0 ? x * power_of_two(lift) : x);
  const int exponent = static_cast<int>(bits >> 52) - 1023 - lift;
  const double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
  return m < kSqrt2 ? Split{m, exponent} : Split{m * 0.5, exponent + 1};
}

/// ln of a mantissa of `split`.
constexpr double log_mantissa(double m) {
  return twice_atanh((m - 1) / (m + 1));
}

constexpr double sin_quarter(double r) {  // |r| <= pi/4
  constexpr std::array<double, 9> kOdd = {1.0,
                                          -1.0 / 6,
                                          1.0 / 120,
                                          -1.0 / 5040,
                                          1.0 / 362880,
                                          -1.0 / 39916800,
                                          1.0 / 6227020800.0,
                                          -1.0 / 1307674368000.0,
                                          1.0 / 355687428096000.0};
  return r * polynomial(kOdd, r * r);
}

constexpr double cos_quarter(double r) {  // |r| <= pi/4
  constexpr std::array<double, 9> kEven = {1.0,
                                           -1.0 / 2,
                                           1.0 / 24,
                                           -1.0 / 720,
                                           1.0 / 40320,
                                           -1.0 / 3628800,
                                           1.0 / 479001600.0,
                                           -1.0 / 87178291200.0,
                                           1.0 / 20922789888000.0};
  return polynomial(kEven, r * r);
}

/// sin(x + quarter pi/2).
constexpr double sin_shifted(double x, int quarter) {
  if (!(x >= -1e9 && x <= 1e9)) return kNaN;
  const int k = nearest(x * (1 / kHalfPi));
  const double n = k;
  // pi/2 in pieces of 33 bits, so that n times the first two is exact for |n| < 2^20.
  const double r = ((x - n * 1.57079632673412561417e+00) - n * 6.07710050630396597660e-11) -
                   n * 2.02226624879595063154e-21;
  const auto q = static_cast<unsigned>(k + quarter) & 3u;
  const double value = (q & 1u) != 0 ? cos_quarter(r) : sin_quarter(r);
  return (q & 2u) != 0 ? -value : value;
}

/// atan(y / x) for 0 <= y <= x, x > 0: from the nearest of five known angles.
constexpr double atan_octant(double y, double x) {
  constexpr std::array<double, 5> kKnown = {0.0, 0.24497866312686415417, 0.46364760900080611621,
                                            0.64350110879328438680, 0.78539816339744830962};
  constexpr std::array<double, 10> kOdd = {1.0,       -1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,
                                           -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19};
  const int i = nearest(4 * (y / x));
  const double c = 0.25 * i;
  const double z = (y - c * x) / (x + c * y);
  return kKnown[static_cast<std::size_t>(i)] + z * polynomial(kOdd, z * z);
}

constexpr double absolute(double x) {
  return x < 0 ? -x : x;
}

}  // namespace detail

/// e^x - 1, exact to rounding near 0.
constexpr double expm1(double x);

/// e^x; 0 below -745.2, infinite above 709.8.
constexpr double exp(double x) {
  if (x != x) return x;
  if (x > 709.782712893384) return detail::kInfinity;
  if (x < -745.2) return 0;
  const int k = detail::nearest(x * (1 / detail::kLn2));
  const double r = (x - k * detail::kLn2High) - k * detail::kLn2Low;
  return detail::scaled(1 + detail::small_expm1(r), k);
}

/// 2^x; whole x give exact powers.
constexpr double exp2(double x) {
  if (x != x) return x;
  if (x >= 1024) return detail::kInfinity;
  if (x < -1075.5) return 0;
  const int k = detail::nearest(x);
  return detail::scaled(1 + detail::small_expm1((x - k) * detail::kLn2), k);
}

constexpr double expm1(double x) {
  return x > -0.35 && x < 0.35 ? detail::small_expm1(x) : exp(x) - 1;
}

/// Natural logarithm; -infinity at 0, NaN below.
constexpr double log(double x) {
  if (x != x || x == detail::kInfinity) return x;
  if (x <= 0) return x == 0 ? -detail::kInfinity : detail::kNaN;
  const auto [m, e] = detail::split(x);
  return e * detail::kLn2High + (detail::log_mantissa(m) + e * detail::kLn2Low);
}

/// ln(1 + x), exact to rounding near 0.
constexpr double log1p(double x) {
  return x > -0.29 && x < 0.41 ? detail::twice_atanh(x / (2 + x)) : log(1 + x);
}

/// Logarithm to base 2; powers of two give exact whole numbers.
constexpr double log2(double x) {
  if (!(x > 0 && x < detail::kInfinity)) return log(x);
  const auto [m, e] = detail::split(x);
  return e + detail::log_mantissa(m) * (1 / detail::kLn2);
}

/// x^y for x >= 0 (NaN below); x^0 = 1, 0^y = 0 for y > 0 and infinity for y < 0.
constexpr double pow(double x, double y) {
  if (y == 0) return 1;
  if (x == 0) return y > 0 ? 0 : detail::kInfinity;
  return exp(y * log(x));
}

/// sin and cos have the stated accuracy for |x| <= 1e6, and give NaN for |x| > 1e9. x in radians.
constexpr double sin(double x) {
  return detail::sin_shifted(x, 0);
}
constexpr double cos(double x) {
  return detail::sin_shifted(x, 1);
}

/// Angle of (x, y) in radians, in [-pi, pi]. 0 at the origin; the sign of a zero is ignored.
constexpr double atan2(double y, double x) {
  if (x != x || y != y) return detail::kNaN;
  const double ax = detail::absolute(x), ay = detail::absolute(y);
  if (ax == 0 && ay == 0) return 0;
  double angle =
      ay <= ax ? detail::atan_octant(ay, ax) : detail::kHalfPi - detail::atan_octant(ax, ay);
  if (x < 0) angle = detail::kPi - angle;
  return y < 0 ? -angle : angle;
}

constexpr double tanh(double x) {
  const double a = detail::absolute(x);
  if (a > 20) return x < 0 ? -1 : 1;
  const double e = expm1(2 * a);
  const double t = e / (e + 2);
  return x < 0 ? -t : t;
}

/// sinh and cosh: |x| < 709.
constexpr double sinh(double x) {
  const double a = detail::absolute(x);
  const double e = expm1(a);
  const double s = 0.5 * (e + e / (e + 1));
  return x < 0 ? -s : s;
}
constexpr double cosh(double x) {
  const double e = exp(detail::absolute(x));
  return 0.5 * (e + 1 / e);
}

constexpr float exp(float x) {
  return static_cast<float>(exp(static_cast<double>(x)));
}
constexpr float exp2(float x) {
  return static_cast<float>(exp2(static_cast<double>(x)));
}
constexpr float expm1(float x) {
  return static_cast<float>(expm1(static_cast<double>(x)));
}
constexpr float log(float x) {
  return static_cast<float>(log(static_cast<double>(x)));
}
constexpr float log1p(float x) {
  return static_cast<float>(log1p(static_cast<double>(x)));
}
constexpr float log2(float x) {
  return static_cast<float>(log2(static_cast<double>(x)));
}
constexpr float sin(float x) {
  return static_cast<float>(sin(static_cast<double>(x)));
}
constexpr float cos(float x) {
  return static_cast<float>(cos(static_cast<double>(x)));
}
constexpr float tanh(float x) {
  return static_cast<float>(tanh(static_cast<double>(x)));
}
constexpr float sinh(float x) {
  return static_cast<float>(sinh(static_cast<double>(x)));
}
constexpr float cosh(float x) {
  return static_cast<float>(cosh(static_cast<double>(x)));
}
constexpr float pow(float x, float y) {
  return static_cast<float>(pow(static_cast<double>(x), static_cast<double>(y)));
}
constexpr float atan2(float y, float x) {
  return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace pentimento::approx
