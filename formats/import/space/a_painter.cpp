// A-Painter's paintings in space, version 1 (github.com/aframevr/a-painter, README and
// systems/brush.js): `apainter`, the names of brushes, strokes of points with position (m, y up,
// right-handed), orientation, pressure and time (ms). Kept: places as seen from the front of the
// plane that fits them best (or along z), times, pressure, colour, size. Dropped: depth, the
// controller's orientation, the kind of ribbon but for its nearest brush. A trigger draws above a
// pressure of 0.1.

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>

#include "core/optics/srgb.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/byte_reader.h"
#include "formats/import/space/projection.h"
#include "formats/import/space/space_stroke.h"

namespace pentimento::sketch {

namespace {
constexpr std::string_view kMagic(
    "\x08"
    "apainter");
constexpr std::size_t kPointBytes = 3 * 4 + 4 * 4 + 4 + 4;
constexpr std::size_t kStrokeBytes = 1 + 3 * 4 + 4 + 4;
constexpr double kMostSize_m = 1e3, kFar_m = 1e6;

BrushKind kind_of(std::string_view name) {
  const auto has = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
  if (has("single") || has("line") || has("spikes")) return BrushKind::kRigger;
  return has("flat") || has("lines") || has("ribbon") ? BrushKind::kFlat : BrushKind::kRound;
}

class SpacePaintingReader {
 public:
  explicit SpacePaintingReader(const Source& source) : in_(source.name, source.bytes) {}

  Result<std::vector<SpaceStroke>> read() {
    in_.skip(kMagic.size(), "magic");
    if (const int version = in_.u16("version"); in_.ok() && version != 1)
      in_.fail(fmt::format("version {} is not known, only 1", version));
    const int brushes = in_.u8("brushes");
    for (int i = 0; i < brushes && in_.ok(); ++i)
      brushes_.emplace_back(in_.bytes(in_.u8("length of a brush's name"), "name of a brush"));
    const std::uint32_t strokes = in_.count("strokes", kStrokeBytes);
    std::vector<SpaceStroke> out;
    for (std::uint32_t i = 0; i < strokes && in_.ok(); ++i) {
      SpaceStroke stroke = read_stroke();
      if (!stroke.places.empty()) out.push_back(std::move(stroke));
    }
    if (!in_.ok()) return in_.error();
    return out;
  }

 private:
  SpaceStroke read_stroke() {
    SpaceStroke out;
    Stroke& stroke = out.stroke;
    const std::size_t brush = in_.u8("brush of a stroke");
    if (in_.ok() && brush >= brushes_.size())
      in_.fail(fmt::format("brush {} of {}", brush, brushes_.size()));
    else if (in_.ok())
      stroke.brush = kind_of(brushes_[brush]);
    for (double& c : stroke.color)
      c = srgb_to_linear(std::clamp(static_cast<double>(in_.f32("colour")), 0.0, 1.0));
    stroke.width = static_cast<double>(in_.f32("size"));
    if (in_.ok() && !(stroke.width >= 0 && stroke.width <= kMostSize_m))
      in_.fail(fmt::format("size {} m is outside 0..{}", stroke.width, kMostSize_m));
    stroke.width_share_unpressed = 0;  // a ribbon is as wide as size times pressure
    stroke.timed = stroke.has_pressure = true;
    const std::uint32_t points = in_.count("points", kPointBytes);
    for (std::uint32_t i = 0; i < points && in_.ok(); ++i) read_point(out);
    return out;
  }

  void read_point(SpaceStroke& out) {
    Eigen::Vector3d place;
    for (double& v : place) {
      v = static_cast<double>(in_.f32("position"));
      if (std::abs(v) > kFar_m) in_.fail(fmt::format("position {} m is over {}", v, kFar_m));
    }
    in_.skip(4 * 4, "orientation");
    Sample sample;
    sample.pressure = std::clamp(in_.f32("pressure"), 0.0f, 1.0f);
    sample.time_s = in_.u32("time") * 1e-3;
    // A clock that was set back does not stop the hand.
    if (!out.stroke.samples.empty())
      sample.time_s = std::max(sample.time_s, out.stroke.samples.back().time_s);
    out.places.push_back(place);
    out.stroke.samples.push_back(sample);
  }

  ByteReader in_;
  std::vector<std::string> brushes_;
};

}  // namespace

bool is_a_painter(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

Result<Sketch> read_a_painter(const Source& source, const ReadOptions& options) {
  if (!is_a_painter(source.bytes))
    return Error{ErrorCode::kBadInput, source.name + ": offset 0: not a painting of A-Painter"};
  Result<std::vector<SpaceStroke>> strokes = SpacePaintingReader(source).read();
  if (!strokes) return strokes.error();
  std::vector<Eigen::Vector3d> all;
  for (const SpaceStroke& stroke : *strokes)
    all.insert(all.end(), stroke.places.begin(), stroke.places.end());
  const PictureAxes axes =
      options.view == View::kFront ? PictureAxes{} : best_plane(all, Eigen::Vector3d::UnitZ());
  Sketch sketch;
  for (SpaceStroke& stroke : *strokes) {
    for (std::size_t i = 0; i < stroke.places.size(); ++i) {
      const Eigen::Vector2d at = axes(stroke.places[i]);
      stroke.stroke.samples[i].x = at.x();
      stroke.stroke.samples[i].y = at.y();
    }
    sketch.items.emplace_back(std::move(stroke.stroke));
  }
  sketch.report.kept = {"places", "times", "pressure", "colour", "size"};
  sketch.report.guessed = {"brushes, from their names"};
  if (options.view != View::kFront)
    sketch.report.guessed.emplace_back("the view: the plane that fits best");
  sketch.report.dropped = {"depth", "orientation of the controller"};
  return sketch;
}

}  // namespace pentimento::sketch
