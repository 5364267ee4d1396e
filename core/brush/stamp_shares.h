#pragma once
// Which shares of the paint change hands at one stamp. Sliders say them per length of travel, so
// that it does not matter how close stamps lie. Whoever paints asks here, and so does whoever only
// foresees a painting.

#include "core/brush/brush_settings.h"
#include "core/brush/stamp.h"
#include "core/brush/tip_pose.h"

namespace pentimento {

/// 1 - (1 - frac)^lengths: a share per length, over another distance. `frac` is clamped to 0..1.
float share_over(float frac, double lengths);

/// The way that the stamp stands for, in diameters of the tip as it is pressed.
double travelled_diameters(const Stamp& stamp, const TipPose& pose);

/// Of the wet paint under the tip, that the bristles lift, where they hold fully (R22): the
/// slider's share per diameter, or what a rag soaks up, if that is more.
float pickup_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose);

/// Of what the brush holds, that the palette replaces (R22); 0 for a tool that is not dipped.
float refill_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose);

/// Of the difference between neighbouring layers, that the brush mixes away (R28).
float mixing_share(const Stamp& stamp, const BrushSettings& settings, const TipPose& pose);

/// Of what the brush holds beyond its load, that goes back to the canvas where the tip touches
/// fully.
float return_share(const Stamp& stamp, const BrushDefinition& brush, const TipPose& pose);

/// Of the paint that stands above a blade's edge, that comes onto the blade.
float scraped_share(const Stamp& stamp, const TipPose& pose);

}  // namespace pentimento
