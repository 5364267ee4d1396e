#include "replay/output/debug_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "replay/output/debug_legend.h"

namespace pentimento {

namespace {
constexpr int kStripRows = 64;

/// The cell under the centre of pixel `i`.
int cell_of(int i, int pixels, int cells) {
  return static_cast<int>((2 * std::int64_t{i} + 1) * cells / (2 * std::int64_t{pixels}));
}

PictureStrip strip_of(const std::array<Field<float>, 3>& rgb, int y0, int rows) {
  PictureStrip strip{y0, rows, {"R", "G", "B"}, {}};
  for (const Field<float>& plane : rgb)
    strip.plane.push_back(plane.view().window(0, 0, plane.width(), rows));
  return strip;
}

Result<void> hand_on(const PictureStrip& strip, const std::vector<PictureSink*>& sinks) {
  for (PictureSink* sink : sinks) {
    if (Result<void> written = sink->write(strip); !written) return written;
  }
  return {};
}
}  // namespace

OutputSize debug_picture_size(const OutputSize& written) {
  const int width = std::max(written.width, kLeastLegendWidth);
  return {width, written.height + debug_legend_height(width), written.dpi};
}

Result<void> write_debug_picture(const DebugColors& colors, const CanvasSource& canvas,
                                 const ChannelBasis& basis, const DebugFrame& frame,
                                 const std::vector<PictureSink*>& sinks, const Control& control) {
  const CanvasGeometry& grid = canvas.geometry();
  const int width = debug_picture_size({frame.width, frame.height, 0}).width;
  Result<std::array<Field<float>, 3>> legend = draw_debug_legend(colors, width);
  if (!legend) return legend.error();
  // The margin of a narrow picture is the legend's page.
  std::array<Field<float>, 3> strip;
  for (std::size_t c = 0; c < 3; ++c)
    strip[c] = Field<float>(width, kStripRows, (*legend)[c](0, 0));
  DebugRows rows(colors, canvas, basis);
  std::vector<Linear3> line(static_cast<std::size_t>(grid.width));
  int shown = -1;
  for (int y0 = 0; y0 < frame.height; y0 += kStripRows) {
    if (Result<void> go = control.go_on(); !go) return go;
    control.report({"shade", y0, frame.height});
    const int count = std::min(kStripRows, frame.height - y0);
    for (int y = 0; y < count; ++y) {
      const int row = cell_of(frame.top + y0 + y, frame.whole.height, grid.height);
      if (row != shown) rows.paint(shown = row, line);
      for (int x = 0; x < frame.width; ++x) {
        const int cell = cell_of(frame.left + x, frame.whole.width, grid.width);
        const Linear3& color = line[static_cast<std::size_t>(cell)];
        for (std::size_t c = 0; c < 3; ++c) strip[c](x, y) = color[c];
      }
    }
    if (Result<void> went = hand_on(strip_of(strip, y0, count), sinks); !went) return went;
  }
  if (Result<void> read = canvas.status(); !read) return read;
  return hand_on(strip_of(*legend, frame.height, (*legend)[0].height()), sinks);
}

}  // namespace pentimento
