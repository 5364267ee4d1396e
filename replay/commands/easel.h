#pragma once
// The easel: a canvas to paint on from C++, without a log. A stroke takes the time that a hand
// needs for it, and the paint flows meanwhile. The replay of a log with the same strokes also does
// the step that its last event lies in: after step(1) both states are the same, bit for bit. Only
// one thread at a time may use an easel.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/brush/brush_settings.h"
#include "core/optics/lighting.h"
#include "core/simulation/simulation.h"
#include "formats/io/picture_file.h"
#include "formats/log/tables/events.h"

namespace pentimento {

/// A point of a stroke: a place on the canvas, from the top left, y down.
struct StrokePoint {
  double x_m = 0;
  double y_m = 0;
  float pressure = 0.8f;  // 0..1
};

struct EaselPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

class Easel {
 public:
  /// Puts up the canvas of a log's header: size, grid, paper, palette, brushes, model, picture. The
  /// header is not checked, and must be one that a reader of logs accepts. Files that it names are
  /// looked for in the working folder. `threads` 0: as many as the machine has. The hand begins
  /// with the brush `round` and the palette's first pigment. Easels that share `tips` draw the tip
  /// of each brush once; nullptr: only the easel and its forks share. Errors: kBadInput (a pigment
  /// that the library does not have), those of the files.
  static Result<std::unique_ptr<Easel>> open(const log::Header& header, int threads = 0,
                                             std::shared_ptr<TipRack> tips = nullptr);
  ~Easel();

  // The hand. After a name that does not exist nothing more is painted, and write_png() returns the
  // error.
  /// Takes up a brush of the header or a built-in one, with these sliders.
  void take_brush(const std::string& name, const BrushSettings& settings);
  /// Loads the brush with a pigment of the palette.
  void take_color(const std::string& pigment);
  /// Draws a smooth curve through `points`, at `speed_m_s` > 0.
  void stroke(const std::vector<StrokePoint>& points, double speed_m_s = 0.5);

  // The time between strokes.
  /// The hand rests and the paint flows on. `seconds` >= 0.
  void wait(double seconds);
  /// So many steps of the simulation go by. `steps` >= 0.
  void step(int steps);
  /// All paint dries at once.
  void dry();
  /// What the accelerometer of a tablet would read, m/s^2: x right, y up, z out of the canvas.
  /// Lying face up it is (0, 0, 9.81), upright (0, 9.81, 0).
  void set_gravity(double x_m_s2, double y_m_s2, double z_m_s2);

  /// Another easel with the same wet paint, brush and light, which goes on bit for bit as this one
  /// would.
  std::unique_ptr<Easel> fork() const;
  /// The first of the errors above; nothing if there is none.
  const std::optional<Error>& problem() const;
  /// Simulated time, s.
  double time_s() const;

  /// The picture of the canvas as it is now, as red, green and blue of 8 bits, sRGB, row by row
  /// from the top. `width` as in write_png(). Errors: the first of the calls above, those of
  /// OpenGL.
  Result<EaselPicture> picture(int width = 0);

  /// The picture of the canvas as it is now, 8 bits a colour. `width` in pixels, 0: one per cell;
  /// the height follows the canvas. Errors: the first of the calls above, kIo, those of OpenGL.
  Result<Published> write_png(const std::string& path, int width = 0);

  /// The light of the pictures. It begins as the light of a log without events of light.
  Lighting& lighting();
  /// The simulation, for what has no call here: gravity, model, the state. Do not call its step();
  /// the easel does that.
  Simulation& simulation();

 private:
  struct Impl;
  explicit Easel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento
