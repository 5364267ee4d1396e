#include "formats/import/space/tilt_strokes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/optics/srgb.h"
#include "formats/import/sketch/byte_reader.h"

namespace pentimento::sketch {

namespace {
constexpr std::uint32_t kSentinel = 0xC576A5CD;
constexpr std::size_t kTiltStrokeBytes = 4 + 4 * 4 + 4 + 4 + 4 + 4;
constexpr std::size_t kPlaceBytes = 3 * 4 + 4 * 4;  // position and orientation of a point
constexpr double kFar_dm = 1e6, kMostWidth_dm = 1e4;

// Bits of a stroke's mask: which extensions follow. Up to 15 they have four bytes, then a length.
constexpr int kFlagsBit = 0, kScaleBit = 1, kFirstLongBit = 16;
constexpr std::uint32_t kContinuesGroup = 2;  // of the flags: goes on where the stroke before was
// Bits of a point's mask; each has four bytes.
constexpr int kPressureBit = 0, kTimeBit = 1;
/// The first stamp of a stroke may be of another clock than the rest: in 2394 of 3903 strokes of
/// one painting the second point steps back, or is over a second ahead.
constexpr std::int64_t kMostFirstStep_ms = 1000;

class TiltReader {
 public:
  TiltReader(const std::string& name, std::string_view bytes, const std::vector<TiltBrush>& brushes)
      : in_(name, bytes), brushes_(brushes) {}

  Result<std::vector<SpaceStroke>> read() {
    if (in_.u32("sentinel") != kSentinel) in_.fail("data.sketch does not begin with its sentinel");
    if (const std::int32_t version = in_.i32("version"); in_.ok() && version != 5 && version != 6)
      in_.fail(fmt::format("version {} is not known, only 5 and 6", version));
    in_.skip(4, "reserved");
    in_.skip(in_.count("additional bytes", 1), "additional header");
    const std::uint32_t count = in_.count("strokes", kTiltStrokeBytes);
    std::vector<SpaceStroke> out;
    std::int64_t last_head_ms = -1;
    for (std::uint32_t i = 0; i < count && in_.ok(); ++i) {
      SpaceStroke stroke = read_stroke();
      if (stroke.places.empty()) continue;
      stroke.twin = continues_ && head_ms_ == last_head_ms;
      last_head_ms = head_ms_;
      out.push_back(std::move(stroke));
    }
    if (!in_.ok()) return in_.error();
    return out;
  }

 private:
  SpaceStroke read_stroke() {
    SpaceStroke out;
    Stroke& stroke = out.stroke;
    read_brush(stroke);
    for (double& c : stroke.color)
      c = srgb_to_linear(std::clamp(static_cast<double>(in_.f32("colour")), 0.0, 1.0));
    stroke.opacity = std::clamp(static_cast<double>(in_.f32("alpha")), 0.0, 1.0);
    stroke.width = static_cast<double>(in_.f32("size"));
    const std::uint32_t stroke_mask = in_.u32("mask of a stroke");
    const std::uint32_t point_mask = in_.u32("mask of points");
    read_extensions(stroke_mask, stroke);
    if (in_.ok() && !(stroke.width >= 0 && stroke.width <= kMostWidth_dm))
      in_.fail(fmt::format("width {} dm is outside 0..{}", stroke.width, kMostWidth_dm));
    stroke.timed = true;
    stroke.has_pressure = (point_mask >> kPressureBit & 1) != 0;
    const std::size_t point_bytes =
        kPlaceBytes + 4 * static_cast<std::size_t>(std::popcount(point_mask));
    const std::uint32_t points = in_.count("points", point_bytes);
    stamps_ms_.clear();
    for (std::uint32_t i = 0; i < points && in_.ok(); ++i) read_point(point_mask, out);
    set_times(stroke);
    return out;
  }

  void read_brush(Stroke& stroke) {
    const std::int32_t brush = in_.i32("brush of a stroke");
    if (!in_.ok()) return;
    if (brush < 0 || static_cast<std::size_t>(brush) >= brushes_.size())
      return in_.fail(fmt::format("brush {} of {}", brush, brushes_.size()));
    const TiltBrush& named = brushes_[static_cast<std::size_t>(brush)];
    stroke.brush = kind_of_tilt_brush(named.name);
    stroke.width_share_unpressed = named.width_share_unpressed;
  }

  /// Those that matter change the stroke: flags and scale.
  void read_extensions(std::uint32_t mask, Stroke& stroke) {
    continues_ = false;
    for (int bit = 0; bit < 32 && in_.ok(); ++bit) {
      if ((mask >> bit & 1) == 0) continue;
      if (bit == kFlagsBit)
        continues_ = (in_.u32("flags of a stroke") & kContinuesGroup) != 0;
      else if (bit == kScaleBit)
        stroke.width *= static_cast<double>(in_.f32("scale of a stroke"));
      else if (bit < kFirstLongBit)
        in_.skip(4, "extension of a stroke");
      else
        in_.skip(in_.count("bytes of an extension", 1), "extension of a stroke");
    }
  }

  void read_point(std::uint32_t mask, SpaceStroke& out) {
    Eigen::Vector3d place;
    for (double& v : place) {
      v = static_cast<double>(in_.f32("position"));
      if (std::abs(v) > kFar_dm) in_.fail(fmt::format("position {} dm is over {}", v, kFar_dm));
    }
    place.z() = -place.z();  // the file's axes are left-handed
    in_.skip(4 * 4, "orientation");
    Sample sample;
    std::uint32_t stamp_ms = 0;
    for (int bit = 0; bit < 32 && in_.ok(); ++bit) {
      if ((mask >> bit & 1) == 0) continue;
      if (bit == kPressureBit)
        sample.pressure = std::clamp(in_.f32("pressure"), 0.0f, 1.0f);
      else if (bit == kTimeBit)
        stamp_ms = in_.u32("time");
      else
        in_.skip(4, "extension of a point");
    }
    out.places.push_back(place);
    out.stroke.samples.push_back(sample);
    stamps_ms_.push_back(stamp_ms);
  }

  /// From the head's stamp on, by the differences of the rest; a step back is none.
  void set_times(Stroke& stroke) {
    if (stamps_ms_.empty()) return;
    head_ms_ = stamps_ms_.front();
    std::int64_t at_ms = head_ms_;
    for (std::size_t i = 0; i < stamps_ms_.size(); ++i) {
      const std::int64_t step_ms =
          i == 0 ? 0 : std::max<std::int64_t>(0, stamps_ms_[i] - stamps_ms_[i - 1]);
      if (i != 1 || step_ms <= kMostFirstStep_ms) at_ms += step_ms;
      stroke.samples[i].time_s = static_cast<double>(at_ms) * 1e-3;
    }
  }

  ByteReader in_;
  const std::vector<TiltBrush>& brushes_;
  bool continues_ = false;
  std::int64_t head_ms_ = 0;
  std::vector<std::int64_t> stamps_ms_;
};
}  // namespace

Result<std::vector<SpaceStroke>> read_tilt_strokes(const std::string& name, std::string_view bytes,
                                                   const std::vector<TiltBrush>& brushes) {
  return TiltReader(name, bytes, brushes).read();
}

}  // namespace pentimento::sketch
