#pragma once
// A log's strokes as a coarse picture, for terminals. Not the painting: lines of the picked
// colours, without relief, mixing or drying.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Two blanks on that colour, linear light, for a terminal of 24-bit colours.
std::string color_patch(const Rgb& color);

class StrokePreview {
 public:
  /// `columns` characters wide, each of two cells, one above the other.
  StrokePreview(const Header& header, int columns);

  /// The colour of a pigment of the header, linear light; others are dark.
  void set_pigment(const std::string& name, const Rgb& color) { pigments_[name] = color; }
  void add(const Event& event);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The cell's colour; nothing where nobody painted.
  std::optional<Rgb> at(int x, int y) const;
  /// Half blocks in 24-bit colours, a line feed after each row.
  std::string text() const;

 private:
  struct PlaceBefore {
    double x_m = 0, y_m = 0;
  };
  void touch(const Touch& touch);
  void dab(double x_m, double y_m);
  void clear();

  int width_, height_;
  double cell_m_;
  double size_m_;
  Rgb color_ = {0.02, 0.02, 0.02};
  bool wipes_ = false;  // the hand holds the rag
  std::map<std::string, Rgb> pigments_;
  std::map<std::int64_t, PlaceBefore> hands_;
  std::vector<std::optional<Rgb>> cells_;
};

}  // namespace pentimento::log
