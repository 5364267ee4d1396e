#pragma once
// The hand at the tablet and its controls: a cue of the timeline becomes calls to a painter, which
// is the simulation or whoever foresees what that will take.

#include <array>
#include <optional>
#include <set>

#include "core/brush/brush_settings.h"
#include "core/optics/paints/paint_maker.h"
#include "core/simulation/painter.h"
#include "replay/log/brushes.h"
#include "replay/log/log_files.h"
#include "replay/log/palette.h"
#include "replay/play/replay_substrate.h"
#include "replay/timeline/cue.h"

namespace pentimento {

/// What the hand needs besides the painter; all outlive it.
struct HandInput {
  const BrushTable& brushes;
  const Palette& palette;
  int first_color = 0;  // index into the palette
  LogFiles& files;
  std::optional<Vec3f> fixed_gravity;           // in place of the log's, core's frame
  ReplaySubstrate* detail_substrate = nullptr;  // of the detail canvas, if there is one
  PaintMaker maker = {};                        // of the simulation's optics
};

class Hand {
 public:
  /// Puts the first brush, loaded with the first colour, into the hand of a tablet lying face up.
  Hand(Painter& painter, const HandInput& input);

  /// `next`: the cue that will probably follow; nullptr: unknown. Errors: those of a file that a
  /// `load` names.
  Result<void> apply(const Cue& cue, const Cue* next = nullptr);
  /// What the cue does to the hand itself (brush, sliders, colours, gravity, model, the ground of
  /// the detail canvas) and not to the paint: for a canvas that has it already. Errors: as of
  /// apply().
  Result<void> follow(const Cue& cue);
  /// Of the strokes that it followed: the touches that are still down.
  const std::set<int>& followed_down() const { return followed_down_; }

 private:
  Result<void> act(const log::Action& action);
  void dip(const log::Color& color);
  void slide(const log::Slider& slider);
  Result<void> load(const log::Load& load);
  Result<std::array<Field<float>, 3>> read_picture(const log::Load& load);
  void show_to_detail(const std::array<Field<float>, 3>& rgb);

  Painter& painter_;
  const HandInput input_;
  BrushSettings settings_;
  std::set<int> followed_down_;
};

/// From the accelerometer's frame (y up) into core's (y down).
Vec3f core_gravity(const log::Gravity& gravity);

}  // namespace pentimento
