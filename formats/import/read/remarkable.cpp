// Pages of the reMarkable tablet, versions 3, 5 and 6 (github.com/bsdz/remarkable-layers and
// github.com/ricklupton/rmscene): 43 bytes of `reMarkable .lines file, version=N`, then layers of
// strokes, or from version 6 on blocks. Kept: places, pressure, width (the widest point's), colour,
// eraser, layers' order. Dropped: speed, whose unit is unknown, so that there are no times; the
// direction, which is that of motion and no tilt; text; lines that were deleted. Pens become the
// nearest brushes, highlighters and shaders thin paint.

#include <fmt/format.h>

#include <algorithm>

#include "formats/import/read/readers.h"
#include "formats/import/read/remarkable_blocks.h"
#include "formats/import/read/remarkable_pens.h"
#include "formats/import/sketch/layers.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr std::string_view kMagic = "reMarkable .lines file, version=";
constexpr std::size_t kHeadBytes = 43;
constexpr double kMostWidth_px = 1872;

/// Layers of strokes, as versions 3 and 5 have them.
Result<RemarkableScene> read_layers(ByteReader& in, int version) {
  const std::size_t stroke_bytes = version >= 5 ? 24 : 20;
  RemarkableScene scene;
  const std::uint32_t layers = in.count("layers", 4);
  for (std::uint32_t layer = 0; layer < layers && in.ok(); ++layer) {
    const std::uint32_t strokes = in.count("strokes", stroke_bytes);
    for (std::uint32_t i = 0; i < strokes && in.ok(); ++i) {
      Stroke stroke;
      stroke.layer = static_cast<int>(layer);
      set_pen(in.u32("pen"), stroke);
      set_pen_color(in.u32("colour"), 0, stroke);
      in.skip(4, "stroke");
      stroke.width = std::clamp(static_cast<double>(in.f32("width")), 0.0, kMostWidth_px);
      if (version >= 5) in.skip(4, "stroke");
      const std::uint32_t points = in.count("points", kLongPointBytes);
      for (std::uint32_t p = 0; p < points && in.ok(); ++p) read_long_point(in, stroke);
      if (!stroke.samples.empty()) scene.strokes.push_back(std::move(stroke));
    }
  }
  if (!in.ok()) return in.error();
  return scene;
}

/// The page, unless something is painted beyond it, as on a page that was scrolled.
std::optional<Page> page_of(const RemarkableScene& scene, bool from_middle) {
  const Page page = {from_middle ? -scene.width_px / 2 : 0, 0, scene.width_px, scene.height_px};
  for (const Stroke& stroke : scene.strokes)
    for (const Sample& s : stroke.samples)
      if (s.x < page.x || s.x > page.x + page.width || s.y < page.y || s.y > page.y + page.height)
        return {};
  return page;
}
}  // namespace

bool is_remarkable(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

Result<Sketch> read_remarkable(const Source& source, const ReadOptions&) {
  ByteReader in(source.name, source.bytes);
  const std::string_view head = in.bytes(kHeadBytes, "head");
  if (in.ok() && !head.starts_with(kMagic)) in.fail("not a page of a reMarkable");
  if (!in.ok()) return in.error();
  const int version = head[kMagic.size()] - '0';
  if (version != 3 && version != 5 && version != 6) {
    in.fail(fmt::format("version {} is not known, only 3, 5 and 6",
                        quotable(head.substr(kMagic.size(), 1))));
    return in.error();
  }
  Result<RemarkableScene> scene =
      version == 6 ? read_remarkable_blocks(in) : read_layers(in, version);
  if (!scene) return scene.error();
  Sketch sketch;
  sketch.page = page_of(*scene, version == 6);
  sketch.report.kept = {"places", "pressure", "width", "colour", "eraser"};
  sketch.report.guessed = {"times", "brushes, from the pens"};
  sketch.report.dropped = {"speed"};
  if (scene->deleted > 0)
    sketch.report.dropped.push_back(fmt::format("{} deleted lines", scene->deleted));
  for (Stroke& stroke : scene->strokes) sketch.items.emplace_back(std::move(stroke));
  if (paint_layer_by_layer(sketch) > 1)
    sketch.report.kept.emplace_back("layers, each dry before the next");
  return sketch;
}

}  // namespace pentimento::sketch
