#pragma once
// Debug views: one quantity of the canvas as colours, without light, for people who look for a
// fault. They read any canvas, however large, row by row.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/canvas/canvas_source.h"
#include "core/debug/color_map.h"
#include "core/optics/channels.h"

namespace pentimento {

enum class DebugView {
  kHeight,    // of the surface: paper, dried and wet paint; m
  kVelocity,  // of the surface: hue is direction, brightness speed; m/s
  kPigment,   // amount in all layers
  kLayers,    // how many layers hold pigment
  kWetness    // depth of wet paint, m; dried paint and bare canvas apart
};

inline constexpr std::string_view kDebugViewNames = "height, velocity, pigment, layers, wetness";
/// nullopt if there is no such view.
std::optional<DebugView> debug_view_named(std::string_view name);
std::string_view debug_view_name(DebugView view);

/// The scale of a view's colours: values from `from` to `to`, in units of `unit_size` SI units.
struct DebugScale {
  double from = 0, to = 1;
  double unit_size = 1;
  std::string unit;  // "mm"; empty: a number
};

/// The values of `view` on the canvas, widened to round numbers: ends of one digit, 1, 2 or 5.
/// Reads every row once. Values that are not finite are left out.
DebugScale measure_debug_scale(DebugView view, const CanvasSource& canvas,
                               const ChannelBasis& basis);

/// A colour that stands for something outside the scale, such as "bare canvas".
struct DebugSwatch {
  Code8 color;
  std::string name;
};

/// Values that are not finite have this colour in every view.
inline constexpr Code8 kNotFiniteColor = {255, 0, 255};

/// How values of a view become colours.
class DebugColors {
 public:
  DebugColors(DebugView view, const DebugScale& scale) : view_(view), scale_(scale) {}

  /// Colour of a value on the scale (SI units). For velocity: of a speed to the right.
  Linear3 at(double value) const;
  /// Colour of a surface velocity: x right, y down, m/s.
  Linear3 moving(double x_m_s, double y_m_s) const;
  /// The place of `value` on the scale's bar, 0..1, and the inverse. Speeds and amounts of pigment
  /// go with the square root, so that slow and thin paint can be seen.
  double share_of(double value) const;
  double value_at(double share) const;

  /// What is shown beside the scale.
  std::vector<DebugSwatch> swatches() const;
  DebugView view() const { return view_; }
  const DebugScale& scale() const { return scale_; }

 private:
  DebugView view_;
  DebugScale scale_;
};

/// Reads rows of a canvas as colours.
class DebugRows {
 public:
  /// All references must outlive the object.
  DebugRows(const DebugColors& colors, const CanvasSource& canvas, const ChannelBasis& basis);

  /// The values on the scale of all cells of row y; where the view shows something else, `mark`
  /// says which swatch, else -1.
  void read(int y, std::span<float> value, std::span<std::int8_t> mark);
  /// Colours of all cells of row y.
  void paint(int y, std::span<Linear3> out);

 private:
  std::span<const float> plane(PlaneId id, int y, std::size_t slot);
  void read_pigment(int y, std::span<float> value);
  void count_layers(int y, std::span<float> value);
  void read_wetness(int y, std::span<float> value, std::span<std::int8_t> mark);

  const DebugColors& colors_;
  const CanvasSource& canvas_;
  const ChannelBasis& basis_;
  std::vector<float> lines_[3];
  std::vector<float> values_;
  std::vector<std::int8_t> marks_;
};

}  // namespace pentimento
