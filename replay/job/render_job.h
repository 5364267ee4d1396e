#pragma once
// The job of `pentimento render`, as plain values.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/debug/debug_view.h"
#include "core/model/model.h"
#include "core/optics/lighting.h"
#include "core/shading/shader.h"
#include "formats/color/color_profile.h"
#include "formats/log/reader.h"
#include "replay/job/film_choice.h"
#include "replay/job/output_size.h"
#include "replay/job/stop_points.h"

namespace pentimento {

/// The light that the user wants in place of the light of a log or dump.
struct LightChoice {
  std::optional<std::array<double, 3>> direction;  // viewer's frame, y up
  bool follow_gravity = false;
  std::optional<double> intensity;
  std::vector<Lamp> lamps;        // in place of all; empty: as they are
  std::string environment;        // a panorama's file; empty: as it is
  bool soft_environment = false;  // gloss shows no more of it than nine harmonics
  log::PictureSpec picture;
};

/// Which files are written, and how.
struct PictureChoice {
  std::vector<std::string> outputs;  // of -o
  int bit_depth = 8;                 // of PNG: 8 or 16
  bool full_float = false;           // of EXR
  ColorProfile profile = ColorProfile::kSrgb;
  bool dither = false;            // of PNG with 8 bit, and of videos
  double frames_per_second = 25;  // of videos
  std::vector<std::string> aovs;
  std::optional<DebugView> debug_view;     // in place of the lit picture
  std::optional<std::array<int, 4>> crop;  // x, y, width, height in pixels of the whole picture
  int tile = kPictureTile;
  GlBackend backend = GlBackend::kAuto;
  bool no_clobber = false;
};

/// How a picture that is larger than the log's grid gets its detail.
enum class Refine {
  kGuided,  // the simulation runs on the log's grid; a detail canvas follows it: the same painting
  kDirect   // the simulation runs at the picture's size: another painting
};

/// Where and how often the work of a job is saved, so that it can go on after an interruption.
struct CheckpointChoice {
  std::string folder;  // empty: never
  double every_s = 600;
  std::optional<std::int64_t> every_steps;  // in place of `every_s`
};

struct RenderJob {
  std::string log;   // "-" = standard input
  std::string from;  // a state dump to start from; empty: an empty canvas
  SizeRequest size;
  std::optional<Refine> refine;     // none: guided, but direct with `sim_scale`
  std::optional<int> detail;        // fine cells per cell of the guide, 1..32; none: by the size
  std::optional<double> sim_scale;  // simulation grid / output size; direct only
  std::vector<StopPoint> stops;
  FilmChoice film;
  std::optional<double> settle_s;
  std::vector<std::pair<std::string, std::string>> model;  // --set, names without "model."
  std::optional<std::array<double, 3>> gravity;            // m/s^2, y up, in place of the log's
  LightChoice light;
  PictureChoice picture;
  int threads = 0;                         // 0 = all
  std::optional<std::int64_t> max_memory;  // bytes; none: what the machine has
  std::string hashes;                      // a file for the hashes of each step; empty: none
  std::string scratch;                     // a folder for what does not fit in memory; empty: none
  CheckpointChoice checkpoint;
  log::ReaderOptions reading;
  std::string command;  // the command line without its -o, for provenance
};

}  // namespace pentimento
