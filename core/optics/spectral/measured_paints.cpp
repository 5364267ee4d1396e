#include "core/optics/spectral/measured_paints.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/base/check.h"
#include "core/optics/plain_name.h"

namespace pentimento {
namespace {

/// What stands before `separator`, which is cut off `text` with it.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// "BoneBlack" as "Golden Bone Black".
std::string spelled(std::string_view name) {
  std::string out = "Golden";
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') out += ' ';
    out += c;
  }
  return out;
}

Spectrum values(std::string_view text) {
  Spectrum out{};
  for (double& v : out) {
    const std::string_view part = take(text, ',');
    const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), v);
    PENTIMENTO_CHECK(problem == std::errc() && end == part.data() + part.size());
    v *= kMeasuredScale;
  }
  return out;
}

std::vector<SpectralPaint> parse() {
  std::vector<SpectralPaint> paints;
  std::string_view text = measured_paint_table();
  take(text, '\n');  // the head
  while (!text.empty()) {
    std::string_view line = take(text, '\n');
    const std::string_view name = take(line, ',');
    take(line, ',');  // colour index
    if (take(line, ',') == "K") {
      paints.push_back({spelled(name), values(line), {}});
    } else {
      paints.back().S = values(line);
    }
  }
  return paints;
}

}  // namespace

std::span<const SpectralPaint> measured_paints() {
  static const std::vector<SpectralPaint> paints = parse();
  return paints;
}

const SpectralPaint* find_measured_paint(std::string_view name) {
  const std::string wanted = plain_name(name);
  for (const SpectralPaint& paint : measured_paints())
    if (plain_name(paint.name) == wanted) return &paint;
  return nullptr;
}

}  // namespace pentimento
