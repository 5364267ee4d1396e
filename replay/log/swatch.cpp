#include "replay/log/swatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/check.h"
#include "core/optics/kubelka_munk.h"
#include "core/optics/srgb.h"
#include "replay/log/palette.h"

namespace pentimento {

std::string coat_hex(const Pigment& paint, double ground) {
  PENTIMENTO_CHECK(paint.K.size() == 3);
  log::Rgb linear{};
  for (std::size_t band = 0; band < 3; ++band) {
    const auto b = static_cast<Eigen::Index>(band);
    linear[band] = km_over(km_film({paint.K(b), paint.S(b)}, 1), ground);
  }
  return hex_of(linear);
}

std::string hex_of(const log::Rgb& linear) {
  std::string hex = "#";
  for (const double band : linear)
    hex += fmt::format("{:02x}", std::lround(255 * linear_to_srgb(std::clamp(band, 0.0, 1.0))));
  return hex;
}

std::optional<log::Rgb> linear_of_hex(const std::string& hex) {
  if (hex.size() != 7 || hex[0] != '#') return {};
  log::Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    unsigned code = 0;
    const char* first = hex.data() + 1 + 2 * c;
    if (std::from_chars(first, first + 2, code, 16).ptr != first + 2) return {};
    out[c] = kSrgb8ToLinear[code];
  }
  return out;
}

std::string swatch_hex(const log::PigmentSpec& spec) {
  const Result<Pigment> paint = make_pigment(spec);
  return paint ? coat_hex(*paint, 1) : "";
}

}  // namespace pentimento
