#include "core/brush/tuft.h"

#include <algorithm>
#include <cmath>

#include "core/brush/noise.h"

namespace pentimento {

namespace {
constexpr std::uint64_t kBristleTrack = std::uint64_t{9} << 32;
constexpr std::uint64_t kClumpTrack = std::uint64_t{10} << 32;
constexpr float kFilmWidth = 2.2f;  // of a bristle's radius: how far the paint around it reaches
constexpr float kBristlesPerClump = 7;
constexpr float kTraceFill = 0.02f;  // of the fullest row: less covers nothing

float uniform(std::uint64_t seed, std::uint64_t track, std::size_t index, std::uint64_t k) {
  return random_uniform(RandomPurpose::kBristle, seed,
                        track + static_cast<std::uint64_t>(index) * 8 + k);
}

struct Clump {
  float u = 0, v = 0, length = 0, load = 1;
};

/// Half the bundle's length along the stroke at v.
float half_length(const Tuft& tuft, float v) {
  const float x = v / tuft.half_v;
  const float round = std::sqrt(std::max(0.0f, 1 - x * x));
  return tuft.half_u * (round + tuft.corner * (1 - round));
}

/// Bristles lie evenly over the width, each at a random place in its share of it, and anywhere
/// along the stroke.
Clump place(const Tuft& tuft, std::uint64_t seed, std::uint64_t track, std::size_t index,
            std::size_t count) {
  const float share =
      (static_cast<float>(index) + uniform(seed, track, index, 0)) / static_cast<float>(count);
  Clump at;
  at.v = (2 * share - 1) * tuft.half_v;
  at.u = (2 * uniform(seed, track, index, 1) - 1) * half_length(tuft, at.v);
  at.length = 2 * uniform(seed, track, index, 2) - 1;
  at.load = 0.55f + 0.45f * uniform(seed, track, index, 3);
  return at;
}

/// Where a bristle's foot is, how hard it touches and how far it trails, pressed down.
struct BristleMark {
  float u = 0, v = 0, tail = 0, radius = 0, value = 0;
};

BristleMark mark_of(const Tuft& tuft, const Bristle& bristle, float press) {
  const float range = tuft.point + tuft.bristles.length_spread + 0.1f;
  const float reach = range * (0.1f + 1.25f * press);
  const float contact = smooth_step(0, 0.35f * range, bristle.length - (1 - reach));
  const float spread = 0.82f + 0.18f * press;
  BristleMark mark;
  mark.u = spread * bristle.u + press * press * bristle.out_u;
  mark.v = spread * bristle.v + press * press * bristle.out_v;
  mark.tail = tuft.drag * (0.15f + 0.85f * press);
  mark.radius = bristle.radius * (0.7f + 0.3f * contact);
  mark.value = bristle.load * contact;
  return mark;
}

/// map = max(map, value) near the foot, less along the tail behind it (towards -u).
void draw_mark(const BristleMark& mark, float radius, float value, Field<float>& map) {
  const int size = map.width();
  const float scale = 0.5f * static_cast<float>(size);
  const auto texel = [&](float x) { return (x + 1) * scale - 0.5f; };
  const auto bound = [&](float x) { return std::clamp(static_cast<int>(x), 0, size - 1); };
  const int x0 = bound(texel(mark.u - mark.tail - radius)), x1 = bound(texel(mark.u + radius) + 1);
  const int y0 = bound(texel(mark.v - radius)), y1 = bound(texel(mark.v + radius) + 1);
  // A mark thinner than a texel keeps its paint by being as faint as it is too wide.
  const float shown = std::max(radius, 0.75f / scale);
  const float height = value * std::min(1.0f, radius / shown);
  for (int y = y0; y <= y1; ++y) {
    const float dv = (static_cast<float>(y) - texel(mark.v)) / scale;
    for (int x = x0; x <= x1; ++x) {
      const float du = (static_cast<float>(x) - texel(mark.u)) / scale;
      const float behind = std::clamp(-du, 0.0f, mark.tail);
      const float along = du + behind;
      const float r = std::sqrt(along * along + dv * dv) / shown;
      if (r >= 1) continue;
      const float fade = mark.tail > 0 ? 1 - 0.6f * behind / mark.tail : 1.0f;
      map(x, y) = std::max(map(x, y), height * fade * (1 - smooth_step(0.3f, 1, r)));
    }
  }
}
/// For each row: the paint of the fullest row so far, over the paint of the fullest row of all. "So
/// far" counts from the first row on, or from the last.
std::vector<float> fill_from(const std::vector<double>& row, bool from_first) {
  const double most = *std::max_element(row.begin(), row.end());
  std::vector<float> fill(row.size());
  double fullest = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t at = from_first ? i : row.size() - 1 - i;
    fullest = std::max(fullest, row[at]);
    fill[at] = static_cast<float>(fullest / most);
  }
  return fill;
}

/// A stroke squeezes its paint to its sides, where it stands as a steep rim. Few bristles reach
/// there, but the paint that they deposit does not thin out with their number.
///   row *= (1 - (1 - f)^3) / f, nothing where f is a trace, f: how full rows are up to this one
void raise_rims(Field<float>& map) {
  std::vector<double> row(static_cast<std::size_t>(map.height()));
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      row[static_cast<std::size_t>(y)] += static_cast<double>(map(x, y));
  if (!(*std::max_element(row.begin(), row.end()) > 0)) return;
  const std::vector<float> above = fill_from(row, true), below = fill_from(row, false);
  for (int y = 0; y < map.height(); ++y) {
    const float f =
        std::min(above[static_cast<std::size_t>(y)], below[static_cast<std::size_t>(y)]);
    const float lack = (1 - f) * (1 - f), full = 1 - lack * lack * lack;
    const float rise = f > 0 ? full / f * smooth_step(kTraceFill, 3 * kTraceFill, f) : 0.0f;
    for (int x = 0; x < map.width(); ++x) map(x, y) = std::min(1.0f, rise * map(x, y));
  }
}
}  // namespace

Tuft tuft_of(TipShape shape) {
  switch (shape) {
    case TipShape::kRound:
      return {0.52f, 0.84f, 0, 0.9f, 0.6f, 0.15f, 0.14f, {200, 0.06f, 0.2f, 0.3f}};
    case TipShape::kFlat:
      return {0.17f, 0.93f, 1, 0.05f, 0.5f, 0.3f, 0.12f, {150, 0.045f, 0.3f, 0.4f}};
    case TipShape::kFilbert:
      return {0.32f, 0.88f, 0, 0.5f, 0.5f, 0.25f, 0.14f, {170, 0.05f, 0.3f, 0.4f}};
    case TipShape::kFan:
      return {0.09f, 0.94f, 1, 0.1f, 0.05f, 0, 0.14f, {90, 0.028f, 0.6f, 0.85f}};
    case TipShape::kRigger:
      return {0.3f, 0.22f, 0, 0.6f, 0.8f, 0, 0.55f, {50, 0.07f, 0.1f, 0.1f}};
    case TipShape::kTexture:
      return {0.95f, 0.95f, 1, 0, 0.3f, 0, 0.05f, {}};
    case TipShape::kBristle:
    case TipShape::kKnife:
    case TipShape::kRag:
      break;
  }
  return {0.34f, 0.92f, 0.5f, 0.15f, 0.2f, 0.3f, 0.2f, {84, 0.04f, 0.65f, 0.6f}};
}

std::vector<Bristle> make_bristles(const Tuft& tuft, std::uint64_t seed) {
  const BristleSet& set = tuft.bristles;
  const std::size_t count = static_cast<std::size_t>(std::max(0, set.count));
  const std::size_t clumps =
      static_cast<std::size_t>(static_cast<float>(count) / kBristlesPerClump) + 1;
  std::vector<Bristle> bristles;
  for (std::size_t i = 0; i < count; ++i) {
    const Clump own = place(tuft, seed, kBristleTrack, i, count);
    const Clump clump = place(tuft, seed, kClumpTrack, i * clumps / count, clumps);
    const float pull = 0.75f * set.clumping;
    Bristle bristle;
    bristle.u = own.u + pull * (clump.u - own.u);
    bristle.v = own.v + pull * (clump.v - own.v);
    // Pressed clumps part: each goes its own way, the outer ones outwards.
    bristle.out_u = 0.06f * set.clumping * clump.length;
    bristle.out_v =
        0.07f * set.clumping * (2 * uniform(seed, kClumpTrack, i * clumps / count, 4) - 1);
    const float x = bristle.u / tuft.half_u, y = bristle.v / tuft.half_v;
    const float uneven = own.length + set.clumping * (clump.length - own.length);
    bristle.length =
        1 - tuft.point * (x * x + y * y) * 0.5f - 0.5f * set.length_spread * (1 - uneven);
    bristle.radius = set.thickness * (0.7f + 0.6f * uniform(seed, kBristleTrack, i, 4));
    const float side = smooth_step(0.7f, 0.9f, std::abs(bristle.v) / tuft.half_v);
    bristle.load =
        own.load * (0.6f + 0.4f * clump.load) * (1 + tuft.ridge * side) / (1 + tuft.ridge);
    bristles.push_back(bristle);
  }
  float longest = 0;
  for (const Bristle& bristle : bristles) longest = std::max(longest, bristle.length);
  for (Bristle& bristle : bristles) bristle.length += 1 - longest;
  return bristles;
}

Field<float> draw_tuft(const Tuft& tuft, const std::vector<Bristle>& bristles, float press,
                       int size) {
  Field<float> map(size, size);
  for (const Bristle& bristle : bristles) {
    const BristleMark mark = mark_of(tuft, bristle, press);
    if (!(mark.value > 0)) continue;
    if (tuft.film > 0)
      draw_mark(mark, kFilmWidth * mark.radius, tuft.film * (0.4f + 0.6f * press) * mark.value,
                map);
    draw_mark(mark, mark.radius, mark.value, map);
  }
  raise_rims(map);
  return map;
}

}  // namespace pentimento
