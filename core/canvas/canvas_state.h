#pragma once
// The state: everything that the simulation knows of a canvas at one moment (R1, R2). It is a plain
// bundle of planes; the code in fluid/, brush/ and layers/ changes them. Not thread-safe.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/field.h"
#include "core/canvas/ground_plane.h"

namespace pentimento {

/// The grid on the canvas: cell (0,0) at the top left; cells need not be square (A4).
struct CanvasGeometry {
  int width = 0;       // cells
  int height = 0;      // cells
  double width_m = 1;  // of the canvas
  double height_m = 1;
  float dx_m() const { return static_cast<float>(width_m / width); }
  float dy_m() const { return static_cast<float>(height_m / height); }
  double cell_area_m2() const { return (width_m / width) * (height_m / height); }
};

struct CanvasState {
  CanvasGeometry geometry;
  int layers = 0;    // planes per channel, bottom layer first
  int channels = 0;  // optics/channels.h says what a channel means
  int bands = 3;     // of the reflectance

  Field<float> depth_m;         // d >= 0, wet paint: volume per area
  Field<float> velocity_x_m_s;  // surface velocity, x right. Where in the cell it lives (centre, or
  Field<float> velocity_y_m_s;  // right and lower face) is the scheme's choice; y down.
  Field<float> base_m;          // b: paper relief + dried paint
  // The paper's relief alone, where it differs from `base_m`: code that changes `base_m` sees to it
  // (read_paper(), write_base()).
  DifferencePlane paper;
  std::vector<GroundPlane> reflectance;  // of the dry layer, one plane per band, linear, in [0,1]
  std::vector<Field<float>> pigment;     // >= 0, [layer * channels + channel]
  Field<std::uint32_t>
      stroke;             // id of the last stroke that touched the cell or ran onto it, 0 = none
  std::int64_t step = 0;  // simulation steps done so far
  // Which tiles of the conservative scheme sleep, and at which gravity they fell asleep
  // (sleep_tiles.h). Part of the state and of a dump. Empty: all tiles are awake. Code that changes
  // planes by anything but a stamp (drying, loading an image, clearing) must empty it.
  std::vector<float> sleep;

  Field<float>& channel(int layer, int c) { return pigment[plane_index(layer, c)]; }
  const Field<float>& channel(int layer, int c) const { return pigment[plane_index(layer, c)]; }

 private:
  std::size_t plane_index(int layer, int c) const {
    return static_cast<std::size_t>(layer) * static_cast<std::size_t>(channels) +
           static_cast<std::size_t>(c);
  }
};

/// The paper's relief alone in the cells x .. x + out.size() - 1 of row y, m.
void read_paper(const CanvasState& state, int x, int y, std::span<float> out);
/// Sets it. `base_m` must have been set before.
void write_paper(CanvasState& state, int x, int y, std::span<const float> paper_m);
/// The paper's relief on the whole grid, m.
Field<float> paper_relief_of(const CanvasState& state);
/// Sets `base_m` in these cells; the paper stays what it was.
void write_base(CanvasState& state, int x, int y, std::span<const float> base_m);

/// A dry canvas at rest: all planes allocated, paper and `base_m` 0, reflectance `white`.
CanvasState make_canvas_state(const CanvasGeometry& geometry, int layers, int channels, int bands,
                              float white);

/// A deep copy.
CanvasState clone_state(const CanvasState& state);

}  // namespace pentimento
