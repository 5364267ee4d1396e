#include "formats/png/chunks.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "formats/io/deflate.h"
#include "formats/io/utf8.h"
#include "formats/png/profile_chunk.h"

namespace pentimento::png {

namespace {

constexpr std::uint8_t kColourGrey = 0, kColourRgb = 2;
constexpr std::uint8_t kPerceptual = 0;  // rendering intent
constexpr std::uint8_t kPerMetre = 1;
constexpr double kInch_m = 0.0254;
constexpr std::size_t kLongestKey = 79;

void append_number(std::uint32_t value, PngBytes& out) {
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append(std::span<const std::uint8_t> bytes, PngBytes& out) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void append_text(std::string_view text, PngBytes& out) {
  out.insert(out.end(), text.begin(), text.end());
}

PngBytes header_data(const Head& head) {
  PngBytes data;
  append_number(static_cast<std::uint32_t>(head.width), data);
  append_number(static_cast<std::uint32_t>(head.height), data);
  data.push_back(static_cast<std::uint8_t>(head.bit_depth));
  data.push_back(head.channels == 1 ? kColourGrey : kColourRgb);
  data.insert(data.end(), {0, 0, 0});  // deflate, the five filters, not interlaced
  return data;
}

PngBytes density_data(double dpi) {
  PngBytes data;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / kInch_m));
  append_number(per_metre, data);
  append_number(per_metre, data);
  data.push_back(kPerMetre);
  return data;
}

/// sRGB has a chunk of its own; others bring their ICC profile.
PngBytes colour_chunk(ColorProfile profile) {
  if (profile == ColorProfile::kSrgb) return chunk("sRGB", PngBytes{kPerceptual});
  return chunk("iCCP", iccp_data(profile));
}

bool key_fits(std::string_view key) {
  return !key.empty() && key.size() <= kLongestKey && is_plain_ascii(key) && key.front() != ' ' &&
         key.back() != ' ' && key.find("  ") == std::string_view::npos &&
         key.find('\n') == std::string_view::npos;
}

/// tEXt where ASCII says it all, else iTXt (UTF-8).
PngBytes text_chunk(std::string_view key, std::string_view value) {
  PngBytes data;
  append_text(key, data);
  data.push_back(0);
  if (is_plain_ascii(value)) {
    append_text(value, data);
    return chunk("tEXt", data);
  }
  data.insert(data.end(), {0, 0, 0, 0});  // not compressed, method 0, no language, no translation
  append_text(valid_utf8(value), data);
  return chunk("iTXt", data);
}

}  // namespace

PngBytes chunk(std::string_view type, std::span<const std::uint8_t> data) {
  PngBytes out;
  out.reserve(data.size() + 12);
  append_number(static_cast<std::uint32_t>(data.size()), out);
  append_text(type, out);
  append(data, out);
  append_number(crc32_of(0, std::span(out).subspan(4)), out);
  return out;
}

Result<PngBytes> file_head(const Head& head, const Provenance& provenance) {
  PngBytes out(std::begin(kSignature), std::end(kSignature));
  append(chunk("IHDR", header_data(head)), out);
  if (head.profile) append(colour_chunk(*head.profile), out);
  if (head.dpi > 0) append(chunk("pHYs", density_data(head.dpi)), out);
  for (const auto& [key, value] : provenance) {
    if (!key_fits(key))
      return Error{ErrorCode::kUsage, fmt::format("provenance key \"{}\" does not fit PNG: 1 to {} "
                                                  "ASCII characters, no outer or double spaces",
                                                  key, kLongestKey)};
    append(text_chunk(key, value), out);
  }
  return out;
}

}  // namespace pentimento::png
