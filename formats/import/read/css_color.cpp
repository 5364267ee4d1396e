// Source: W3C CSS Color Module Level 4, sec. 5.2 (hexadecimal) and 6.1 (names; the common ones).

#include "formats/import/read/css_color.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "core/optics/srgb.h"

namespace pentimento::sketch {

namespace {
struct Name {
  std::string_view name;
  std::string_view digits;
};
constexpr Name kNames[] = {
    {"black", "000000"},     {"silver", "c0c0c0"},    {"gray", "808080"},
    {"grey", "808080"},      {"white", "ffffff"},     {"maroon", "800000"},
    {"red", "ff0000"},       {"purple", "800080"},    {"fuchsia", "ff00ff"},
    {"magenta", "ff00ff"},   {"green", "008000"},     {"lime", "00ff00"},
    {"olive", "808000"},     {"yellow", "ffff00"},    {"navy", "000080"},
    {"blue", "0000ff"},      {"teal", "008080"},      {"aqua", "00ffff"},
    {"cyan", "00ffff"},      {"orange", "ffa500"},    {"brown", "a52a2a"},
    {"pink", "ffc0cb"},      {"gold", "ffd700"},      {"indigo", "4b0082"},
    {"violet", "ee82ee"},    {"crimson", "dc143c"},   {"coral", "ff7f50"},
    {"salmon", "fa8072"},    {"tan", "d2b48c"},       {"beige", "f5f5dc"},
    {"khaki", "f0e68c"},     {"darkblue", "00008b"},  {"darkgreen", "006400"},
    {"darkred", "8b0000"},   {"darkgray", "a9a9a9"},  {"darkgrey", "a9a9a9"},
    {"lightgray", "d3d3d3"}, {"lightgrey", "d3d3d3"}, {"transparent", "00000000"}};

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

std::optional<CssColor> from_digits(std::string_view digits) {
  const bool is_short = digits.size() == 3 || digits.size() == 4;
  if (!is_short && digits.size() != 6 && digits.size() != 8) return {};
  const std::size_t each = is_short ? 1 : 2;
  std::array<int, 4> channel = {0, 0, 0, 255};
  for (std::size_t i = 0; i * each < digits.size(); ++i) {
    const int high = digit_of(digits[i * each]), low = digit_of(digits[i * each + each - 1]);
    if (high < 0 || low < 0) return {};
    channel[i] = high * 16 + low;
  }
  CssColor color;
  for (std::size_t i = 0; i < 3; ++i)
    color.linear[i] = kSrgb8ToLinear[static_cast<std::size_t>(channel[i])];
  color.opacity = channel[3] / 255.0;
  return color;
}
}  // namespace

std::optional<CssColor> css_color(std::string_view text) {
  constexpr std::size_t kLongest = 16;
  if (text.size() > kLongest) return {};
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (lower.starts_with('#')) return from_digits(std::string_view(lower).substr(1));
  const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                   [&](const Name& n) { return n.name == lower; });
  if (found == std::end(kNames)) return {};
  return from_digits(found->digits);
}

}  // namespace pentimento::sketch
