#include "formats/import/space/camera.h"

#include <algorithm>

namespace pentimento::sketch {

namespace {
constexpr double kBesideShare = 0.5;  // of the picture's size: strokes reach that far beside it
constexpr double kLift_s = 0.2;       // between two strokes

/// A part of a stroke that is seen without a gap.
struct SeenStroke {
  Stroke stroke;
  double depth = 0;
};

bool is_seen(const PinholeCamera& camera, const Eigen::Vector3d& point) {
  if (camera.depth(point) < camera.near) return false;
  const Eigen::Vector2d at = camera(point);
  const double reach = 1 + 2 * kBesideShare;
  return std::abs(at.x()) <= reach * camera.half_height * camera.aspect &&
         std::abs(at.y()) <= reach * camera.half_height;
}

double mean_depth(const SpaceStroke& stroke, const PinholeCamera& camera, std::size_t first,
                  std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += camera.depth(stroke.places[i]);
  return sum / static_cast<double>(last - first);
}

/// The part from sample `first` to before `last`, of which all are seen.
SeenStroke part_of(const SpaceStroke& from, const PinholeCamera& camera, std::size_t first,
                   std::size_t last) {
  SeenStroke out;
  out.depth = mean_depth(from, camera, first, last);
  out.stroke = from.stroke;
  out.stroke.width = from.stroke.width / out.depth;
  out.stroke.samples.assign(from.stroke.samples.begin() + static_cast<std::ptrdiff_t>(first),
                            from.stroke.samples.begin() + static_cast<std::ptrdiff_t>(last));
  for (std::size_t i = first; i < last; ++i) {
    const Eigen::Vector2d at = camera(from.places[i]);
    out.stroke.samples[i - first].x = at.x();
    out.stroke.samples[i - first].y = at.y();
  }
  return out;
}

/// The parts of a stroke that are seen; counts the points that are not.
void add_seen(const SpaceStroke& from, const PinholeCamera& camera, std::vector<SeenStroke>& out,
              int& unseen) {
  const std::size_t count = from.places.size();
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first;
    while (last < count && is_seen(camera, from.places[last])) ++last;
    if (last > first) out.push_back(part_of(from, camera, first, last));
    if (last < count) ++unseen;
    first = last + 1;
  }
}

bool is_hidden_twin(const SpaceStroke& twin, const SpaceStroke& partner,
                    const PinholeCamera& camera) {
  if (!twin.twin || twin.places.empty()) return false;
  const auto all_seen = [&](const SpaceStroke& stroke) {
    return std::all_of(stroke.places.begin(), stroke.places.end(),
                       [&](const Eigen::Vector3d& p) { return is_seen(camera, p); });
  };
  if (!all_seen(twin) || !all_seen(partner)) return false;
  const auto seen = [&](const SpaceStroke& stroke) {
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector3d& p : stroke.places) places.push_back(camera(p));
    return places;
  };
  return twin_is_hidden(seen(twin), seen(partner),
                        twin.stroke.width / mean_depth(twin, camera, 0, twin.places.size()));
}

/// One after another, each as long as it was.
void lay_end_to_end(std::vector<Stroke>& strokes) {
  double clock_s = 0;
  for (Stroke& stroke : strokes) {
    const double shift_s = clock_s - stroke.samples.front().time_s;
    for (Sample& sample : stroke.samples) sample.time_s += shift_s;
    clock_s = stroke.samples.back().time_s + kLift_s;
  }
}
}  // namespace

bool twin_is_hidden(const std::vector<Eigen::Vector2d>& twin,
                    const std::vector<Eigen::Vector2d>& partner, double width) {
  if (twin.size() != partner.size()) return false;
  for (std::size_t i = 0; i < twin.size(); ++i)
    if ((twin[i] - partner[i]).norm() > width) return false;
  return true;
}

Sight see(std::span<const SpaceStroke> strokes, const PinholeCamera& camera) {
  Sight out;
  std::vector<SeenStroke> seen;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (i > 0 && is_hidden_twin(strokes[i], strokes[i - 1], camera))
      ++out.merged_twins;
    else
      add_seen(strokes[i], camera, seen, out.unseen_points);
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const SeenStroke& a, const SeenStroke& b) { return a.depth > b.depth; });
  for (SeenStroke& s : seen) out.strokes.push_back(std::move(s.stroke));
  lay_end_to_end(out.strokes);
  return out;
}

}  // namespace pentimento::sketch
