#include <fmt/format.h>

#include <algorithm>

#include "formats/image/resample.h"
#include "replay/compare/compare.h"
#include "replay/compare/flip.h"
#include "replay/compare/plane_difference.h"

namespace pentimento {

namespace {

template <typename Curve>
Field<float> mapped(const Field<float>& plane, const Curve& curve) {
  Field<float> out(plane.width(), plane.height());
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x)
      out(x, y) = static_cast<float>(curve(static_cast<double>(plane(x, y))));
  return out;
}

/// Stored codes of an integer picture, from the linear light it was read as.
Field<float> stored_values(const Field<float>& plane, bool is_alpha, ColorProfile profile) {
  if (is_alpha) return plane.clone();
  return mapped(plane, [profile](double v) { return encode_transfer(profile, v); });
}

/// A copy of `image` without its planes.
Image without_planes(const Image& image) {
  Image out;
  out.width = image.width;
  out.height = image.height;
  out.name = image.name;
  out.format = image.format;
  out.bits = image.bits;
  out.stored_float = image.stored_float;
  out.profile = image.profile;
  out.unknown_profile = image.unknown_profile;
  out.profile_title = image.profile_title;
  return out;
}

/// Converts to the primaries of Rec. 709.
Image as_rec709(const Image& image) {
  Image out = without_planes(image);
  for (const Field<float>& plane : image.plane) out.plane.push_back(plane.clone());
  to_rec709(out);
  return out;
}

/// The planes that FLIP compares: R, G, B, or Y three times; nothing if there is no colour.
std::optional<RgbPlanes> rgb_planes(const Image& image) {
  const Field<float>* grey = image.find("Y");
  const std::array<const Field<float>*, 3> rgb = {image.find("R"), image.find("G"),
                                                  image.find("B")};
  if (rgb[0] != nullptr && rgb[1] != nullptr && rgb[2] != nullptr)
    return RgbPlanes{rgb[0]->view(), rgb[1]->view(), rgb[2]->view()};
  if (grey == nullptr) return std::nullopt;
  return RgbPlanes{grey->view(), grey->view(), grey->view()};
}

void add_flip(const Image& a, const Image& b, const Threads& threads, Comparison& out) {
  if (a.profile != ColorProfile::kSrgb) {  // both: different ones do not come here
    add_flip(as_rec709(a), as_rec709(b), threads, out);
    return;
  }
  const auto left = rgb_planes(a), right = rgb_planes(b);
  if (!left || !right) return;
  const Field<float> map = flip_map(*left, *right, kFlipPixelsPerDegree, threads);
  double sum = 0, largest = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const double v = static_cast<double>(map(x, y));
      sum += v;
      largest = v > largest ? v : largest;
    }
  out.flip_mean = sum / (static_cast<double>(map.width()) * map.height());
  out.flip_max = largest;
}

/// Reduces by area means of linear light, to the size of `other`.
Image reduced(const Image& image, const Image& other) {
  Image out = without_planes(image);
  out.width = other.width;
  out.height = other.height;
  for (const Field<float>& plane : image.plane)
    out.plane.push_back(resample_area(plane.view(), other.width, other.height));
  return out;
}

void note_unknown_profile(const Image& image, const char* which, Comparison& out) {
  if (!image.unknown_profile) return;
  out.notes.push_back(
      fmt::format("the {} picture's colour profile \"{}\" is not known: taken for sRGB", which,
                  image.profile_title));
}

void note_missing(const Image& a, const Image& b, const char* where, Comparison& out) {
  for (const std::string& name : a.name)
    if (b.find(name) == nullptr) {
      out.notes.push_back(fmt::format("channel {} is missing in the {} picture", name, where));
      out.comparable = false;
    }
}

}  // namespace

Comparison compare_pictures(const Image& a, const Image& b, const Threads& threads) {
  if (a.profile != b.profile) {
    Comparison out = compare_pictures(as_rec709(a), as_rec709(b), threads);
    out.notes.push_back(fmt::format("colours: {} against {}, compared as sRGB",
                                    profile_title(a.profile), profile_title(b.profile)));
    return out;
  }
  const int up = whole_ratio({a.width, a.height}, {b.width, b.height});
  const int down = whole_ratio({b.width, b.height}, {a.width, a.height});
  if (up > 1 || down > 1) {
    Comparison out = up > 1 ? compare_pictures(a, reduced(b, a), threads)
                            : compare_pictures(reduced(a, b), b, threads);
    out.reduced = std::max(up, down);
    out.notes.push_back(fmt::format("the larger picture was reduced {} times", out.reduced));
    return out;
  }
  Comparison out;
  out.kind = "picture";
  if (a.width != b.width || a.height != b.height) {
    out.notes.push_back(
        fmt::format("{} x {} pixels against {} x {}", a.width, a.height, b.width, b.height));
    out.comparable = false;
    return out;
  }
  note_unknown_profile(a, "first", out);
  note_unknown_profile(b, "second", out);
  note_missing(a, b, "second", out);
  note_missing(b, a, "first", out);
  const bool as_stored = !a.stored_float && !b.stored_float;
  for (std::size_t c = 0; c < a.plane.size(); ++c) {
    const Field<float>* other = b.find(a.name[c]);
    if (other == nullptr) continue;
    if (as_stored) {
      const bool alpha = a.name[c] == "A";
      const Field<float> left = stored_values(a.plane[c], alpha, a.profile);
      const Field<float> right = stored_values(*other, alpha, b.profile);
      out.planes.push_back(plane_difference(a.name[c], left.view(), right.view(), 1));
    } else {
      out.planes.push_back(plane_difference(a.name[c], a.plane[c].view(), other->view(), 1));
    }
  }
  add_flip(a, b, threads, out);
  return out;
}

}  // namespace pentimento
