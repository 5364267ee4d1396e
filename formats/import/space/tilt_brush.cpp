// Paintings of Tilt Brush and Open Brush (github.com/googlevr/tilt-brush, TiltFile.cs,
// SketchWriter.cs): a header of 16 bytes, then a zip archive with the strokes (`data.sketch`), what
// is known of the scene (`metadata.json`), and a picture of it (`thumbnail.png`). Kept: places as
// the thumbnail's camera saw them, pressure, colour, width, the times within a stroke. Guessed: the
// order, from back to front, as what is in front hides what is behind; brushes, from their names.
// Dropped: depth, the controller's orientation, animation, what was undone. A mirror twin that is
// seen on its partner is left out.

#include <fmt/format.h>

#include <algorithm>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/byte_reader.h"
#include "formats/import/space/camera.h"
#include "formats/import/space/projection.h"
#include "formats/import/space/tilt_scene.h"
#include "formats/import/space/tilt_strokes.h"
#include "formats/io/zip_entry.h"

namespace pentimento::sketch {

namespace {
constexpr std::string_view kTiltMagic = "tilT";
constexpr std::size_t kHeaderBytes = 16;
/// What a painting unpacks to at most: 2.6 million points, a hundred times the largest of ours.
constexpr std::uint64_t kMostSketchBytes = 128u << 20, kMostSceneBytes = 16u << 20;
constexpr std::uint64_t kMostThumbnailBytes = 64u << 20;
constexpr double kLeastAspect = 0.1, kMostAspect = 10;

/// The archive behind the header.
Result<ZipBytes> archive_of(const Source& source) {
  ByteReader in(source.name, source.bytes);
  if (in.bytes(kTiltMagic.size(), "magic") != kTiltMagic) in.fail("not a painting of Tilt Brush");
  const int header = in.u16("size of the header"), version = in.u16("version");
  if (in.ok() && (header != static_cast<int>(kHeaderBytes) || version != 1))
    in.fail(
        fmt::format("header of {} bytes, version {}: only 16 and 1 are known", header, version));
  in.skip(8, "header");
  if (!in.ok()) return in.error();
  return ZipBytes{source.name, source.bytes.substr(kHeaderBytes)};
}

/// Width over height of a PNG (its first chunk); 1 if it is none.
double aspect_of(std::string_view png) {
  constexpr std::size_t kWidthAt = 16;
  if (!png.starts_with("\x89PNG") || png.size() < kWidthAt + 8) return 1;
  const auto big_endian = [&](std::size_t at) {
    double value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value * 256 + static_cast<std::uint8_t>(png[i]);
    return value;
  };
  const double width = big_endian(kWidthAt), height = big_endian(kWidthAt + 4);
  const double aspect = height > 0 ? width / height : 1;
  return aspect >= kLeastAspect && aspect <= kMostAspect ? aspect : 1;
}

void add_seen(const std::vector<SpaceStroke>& strokes, const PinholeCamera& camera,
              Sketch& sketch) {
  Sight sight = see(strokes, camera);
  for (Stroke& stroke : sight.strokes) sketch.items.emplace_back(std::move(stroke));
  sketch.page = camera.page();
  sketch.report.kept = {"places as the thumbnail's camera saw them", "pressure", "colour", "width",
                        "times within strokes"};
  sketch.report.guessed = {"the order, from back to front"};
  if (sight.unseen_points > 0)
    sketch.report.dropped.push_back(
        fmt::format("{} points that the camera does not see", sight.unseen_points));
  if (sight.merged_twins > 0)
    sketch.report.dropped.push_back(
        fmt::format("{} mirror twins that lie on their partners", sight.merged_twins));
}

/// From far away, in the order of painting.
void add_flat(std::vector<SpaceStroke> strokes, const PictureAxes& axes, Sketch& sketch) {
  int merged = 0;
  std::vector<Eigen::Vector2d> places, before;
  for (SpaceStroke& stroke : strokes) {
    places.clear();
    for (const Eigen::Vector3d& place : stroke.places) places.push_back(axes(place));
    if (stroke.twin && twin_is_hidden(places, before, stroke.stroke.width)) {
      ++merged;
      continue;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      stroke.stroke.samples[i].x = places[i].x();
      stroke.stroke.samples[i].y = places[i].y();
    }
    before.swap(places);
    sketch.items.emplace_back(std::move(stroke.stroke));
  }
  sketch.report.kept = {"places", "times", "pressure", "colour", "width"};
  if (merged > 0)
    sketch.report.dropped.push_back(
        fmt::format("{} mirror twins that lie on their partners", merged));
}

/// The plane that fits best, seen from the camera's side.
PictureAxes plane_of(const std::vector<SpaceStroke>& strokes,
                     const std::optional<PinholeCamera>& camera) {
  std::vector<Eigen::Vector3d> all;
  for (const SpaceStroke& stroke : strokes)
    all.insert(all.end(), stroke.places.begin(), stroke.places.end());
  return best_plane(all, camera ? Eigen::Vector3d(-camera->forward) : Eigen::Vector3d::UnitZ());
}
}  // namespace

bool is_tilt_brush(std::string_view bytes) {
  return bytes.starts_with(kTiltMagic);
}

Result<Sketch> read_tilt_brush(const Source& source, const ReadOptions& options) {
  const Result<ZipBytes> archive = archive_of(source);
  if (!archive) return archive.error();
  const Result<std::string> json = read_zip_entry(*archive, "metadata.json", kMostSceneBytes);
  if (!json) return json.error();
  Result<TiltScene> scene = read_tilt_scene(source.name, *json);
  if (!scene) return scene.error();
  const Result<std::string> data = read_zip_entry(*archive, "data.sketch", kMostSketchBytes);
  if (!data) return data.error();
  Result<std::vector<SpaceStroke>> strokes =
      read_tilt_strokes(source.name + ": data.sketch", *data, scene->brushes);
  if (!strokes) return strokes.error();

  Sketch sketch;
  sketch.report.file_strokes = static_cast<std::int64_t>(strokes->size());
  for (const SpaceStroke& stroke : *strokes)
    sketch.report.file_samples += static_cast<std::int64_t>(stroke.places.size());
  sketch.title = scene->title;
  sketch.author = scene->author;
  sketch.recorded_by = "Tilt Brush";
  sketch.paper = scene->background;
  if (options.view == View::kCamera && scene->camera) {
    if (const Result<std::string> png =
            read_zip_entry(*archive, "thumbnail.png", kMostThumbnailBytes))
      scene->camera->aspect = aspect_of(*png);
    add_seen(*strokes, *scene->camera, sketch);
  } else {
    const bool front = options.view == View::kFront;
    const PictureAxes axes = front ? PictureAxes{} : plane_of(*strokes, scene->camera);
    add_flat(std::move(*strokes), axes, sketch);
    if (!front) sketch.report.guessed.emplace_back("the view: the plane that fits best");
  }
  sketch.report.guessed.emplace_back("brushes, from their names");
  if (sketch.paper) sketch.report.guessed.emplace_back("the ground, from the sky's colours");
  sketch.report.dropped.insert(sketch.report.dropped.end(),
                               {"depth", "orientation of the controller", "animation"});
  return sketch;
}

}  // namespace pentimento::sketch
