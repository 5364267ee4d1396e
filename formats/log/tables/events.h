#pragma once
// The action log in memory (docs/action-log.md): header and events as read, in SI, canvas
// coordinates y down, sensors and directions converted where noted. No behaviour.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/model/model.h"
#include "core/optics/lighting.h"

namespace pentimento::log {

using Rgb = std::array<double, 3>;

/// A palette entry as the log gives it; replay turns it into K and S.
struct PigmentSpec {
  std::string name;
  std::optional<Rgb> over_white;  // linear reflectance in [0,1]
  std::optional<Rgb> over_black;
  std::optional<Rgb> color;  // one colour ...
  double opacity = 0.7;      // ... with this share of it over black (A25)
  std::optional<Rgb> K, S;   // per RGB
  struct Coefficients {
    std::vector<double> wavelength_nm, K, S;
  };
  std::optional<Coefficients> spectrum;
  bool library = false;  // `name` is of the built-in library
};

/// A tip of the log's own: a built-in shape or a texture, with what differs from the defaults.
struct BrushSpec {
  struct Bristles {
    std::optional<double> count, thickness, length_spread, clumping;
  };
  using Curve = std::vector<std::array<double, 2>>;  // pressure, value; pressures rise
  std::string name;
  std::string shape;    // a built-in shape, or empty when `texture` is given
  std::string texture;  // file, relative to the log
  std::optional<double> spacing, size_pressure, flow_pressure;
  std::optional<bool> follows_direction;
  std::optional<Bristles> bristles;
  std::optional<double> stiffness, grip, capacity, film, absorb;
  Curve size, flow, splay;  // over pressure; empty: the shape's
};

struct PaperSpec {
  std::string texture = "linen";  // built-in name, or a file
  double relief_m = 0.0003;       // height of the texture's full range
  double scale_m = 0.05;          // side of one repeat of the texture on the canvas
  Rgb reflectance = {0.9, 0.9, 0.9};
};

/// How pictures of this log are developed. A value that is not set has its default.
struct PictureSpec {
  std::optional<double> exposure_ev, varnish, occlusion, white_temperature_K;
  std::optional<std::array<double, 2>> white_xy;
  std::optional<ToneCurve> tone;
};

struct Header {
  int version = 1;
  double canvas_width_m = 1, canvas_height_m = 0.75;
  bool edge_open = false;
  int grid_width = 1024, grid_height = 768;
  double steps_per_second = 45;
  PaperSpec paper;
  std::vector<PigmentSpec> palette;
  std::vector<BrushSpec> brushes;
  Model model;
  PictureSpec picture;
  std::string title, author, recorded_by, recorded_at;
  std::string extensions;  // members named x-..., as "x-a":1,"x-b":[2]; kept, ignored by the replay
};

enum class TouchPhase { kDown, kMove, kUp, kCancel };

struct Touch {
  TouchPhase phase = TouchPhase::kMove;
  std::int64_t id = 0;
  double x_m = 0, y_m = 0;
  std::optional<double> pressure, tilt_x_deg, tilt_y_deg, twist_deg, radius_m;
};
/// The accelerometer's reading as the log has it: y UP. The replay converts it to core's frame.
struct Gravity {
  double x_m_s2 = 0, y_m_s2 = 0, z_m_s2 = 9.81;
};
struct Slider {
  std::string name;
  double value = 0;
};
struct Color {
  std::string pigment;                          // a palette name, or
  std::optional<Rgb> value;                     // a picked colour, linear
  std::optional<std::array<double, 2>> across;  // the part of the brush's width that is dipped
};
struct BrushChange {
  std::string name;
};
struct Dry {};
struct Clear {};
struct Load {
  std::string file;
};
struct Undo {};
struct Redo {};
struct Light {
  int lamp = 0;  // which; one that is new begins as the default lamp
  std::optional<std::array<double, 3>> direction;   // y up
  std::optional<std::array<double, 3>> position_m;  // from the canvas's centre, y up
  std::optional<double> intensity;
  std::optional<Rgb> color;  // linear
  bool follow_gravity = false;
};
struct Environment {
  std::string file;  // or
  std::optional<std::array<std::array<double, 3>, 9>> sh;
  bool soft = false;  // of a file: gloss shows its nine harmonics only
};
struct Camera {
  std::string file;
  double start_s = 0;
  double fov_deg = 60;
  bool mirror = true;
};
struct Step {};
struct Mark {
  std::string name;
};
/// `x-...`: kept word for word, ignored by the replay.
struct Extension {
  std::string type;
  std::string json;
};

using Action = std::variant<Touch, Gravity, Slider, Color, BrushChange, Dry, Clear, Load, Undo,
                            Redo, Light, Environment, Camera, Step, Mark, Extension>;

struct Event {
  std::int64_t time_us = 0;  // from the start, rounded
  std::int64_t line = 0;     // of the log, 1 = header
  Action action;
  std::string extensions;  // as in Header
};

}  // namespace pentimento::log
