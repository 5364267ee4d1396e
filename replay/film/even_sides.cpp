#include "replay/film/even_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "formats/video/video_writer.h"
#include "replay/output/output_set.h"

namespace pentimento {

namespace {
bool has_even_sides(const OutputSize& size) {
  return size.width % 2 == 0 && size.height % 2 == 0;
}

/// The size of even sides whose width is nearest, of smaller ones first. Of a canvas that is a
/// thousand times as wide as high there may be none near.
std::optional<OutputSize> nearest_even(const OutputSize& size, const CanvasGeometry& canvas) {
  constexpr int kFarthest = 2000;  // pixels
  for (int away = 0; away <= kFarthest; ++away) {
    for (const int width : {size.width - away, size.width + away}) {
      if (width < 2) continue;
      const Result<OutputSize> other = output_size({width, {}, {}, {}, 0}, canvas);
      if (other && has_even_sides(*other)) return *other;
    }
  }
  return std::nullopt;
}

/// Words for the end of a message; empty if nothing is known that helps.
std::string remedy(const PictureChoice& picture, const OutputSize& size,
                   const CanvasGeometry& canvas) {
  if (picture.crop) {
    const auto [x, y, width, height] = *picture.crop;
    return fmt::format("; --crop {},{},{},{} would do", x, y, std::max(2, width / 2 * 2),
                       std::max(2, height / 2 * 2));
  }
  const std::optional<OutputSize> even = nearest_even(size, canvas);
  if (!even) return {};
  return fmt::format("; --width {} gives {} x {}", even->width, even->width, even->height);
}
}  // namespace

Result<void> check_even_sides(const PictureChoice& picture, const OutputSize& size,
                              const CanvasGeometry& canvas) {
  const auto film = std::find_if(picture.outputs.begin(), picture.outputs.end(), is_video_name);
  if (film == picture.outputs.end()) return {};
  const Result<OutputSize> written = written_size(picture, size);
  if (!written) return written.error();
  if (has_even_sides(*written)) return {};
  return Error{ErrorCode::kUsage,
               fmt::format("-o {}: a film's sides are even, this one has {} x {} pixels{}", *film,
                           written->width, written->height, remedy(picture, size, canvas))};
}

}  // namespace pentimento
