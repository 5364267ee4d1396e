#pragma once
// A canvas to paint on from C++, without a log. A stroke takes the time that a hand needs for it,
// and the paint flows meanwhile: a log that says the same ends in the same state, bit for bit. One
// instance, one thread at a time.

#include <memory>
#include <string>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/optics/lighting.h"
#include "core/result.h"
#include "core/simulation.h"
#include "formats/io/picture_file.h"
#include "formats/log/events.h"

namespace pentimento {

/// What a stroke goes through: a place on the canvas, from the top left, y down.
struct StrokePoint {
  double x_m = 0;
  double y_m = 0;
  float pressure = 0.8f;  // 0..1
};

class Easel {
 public:
  /// Puts up the canvas of a log's header: size, grid, paper, palette, brushes, model, picture. It
  /// must be one that a reader of logs would accept; it is not checked. Files that it names are
  /// looked for in the working folder. `threads` 0: all that the machine has. In the hand is the
  /// brush `round` with the palette's first pigment. Errors: kBadInput (a pigment that the library
  /// does not have), those of the files.
  static Result<std::unique_ptr<Easel>> open(const log::Header& header, int threads = 0);
  ~Easel();

  // The hand. A name that is not there is an error: nothing more is painted, and write_png() says
  // it.
  /// Takes up a brush of the header or a built-in one, with these sliders.
  void take_brush(const std::string& name, const BrushSettings& settings);
  /// Loads the brush with a pigment of the palette.
  void take_color(const std::string& pigment);
  /// Draws a smooth curve through `points`, at `speed_m_s` > 0.
  void stroke(const std::vector<StrokePoint>& points, double speed_m_s = 0.5);

  // The time between strokes.
  /// The hand rests and the paint flows on. `seconds` >= 0.
  void wait(double seconds);
  /// All paint dries at once.
  void dry();

  /// The picture of the canvas as it is now, 8 bits a colour. `width` in pixels, 0: one per cell;
  /// the height follows the canvas. Errors: the first of the calls above, kIo, those of OpenGL.
  Result<Published> write_png(const std::string& path, int width = 0);

  /// What lights the pictures: at first that of a log which says nothing of it.
  Lighting& lighting();
  /// What has no call here: gravity, model, the state. Its steps are the easel's to do.
  Simulation& simulation();

 private:
  struct Impl;
  explicit Easel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento
