#pragma once
// Which shares of the paint pass between brush and canvas at one stamp. The sliders give them per
// length of travel, so that it does not matter how close stamps lie. The simulation uses these
// functions, and so do the estimates. All shares are in [0,1].

#include "core/brush/brush_settings.h"
#include "core/brush/stamp.h"
#include "core/brush/tip_pose.h"

namespace pentimento {

/// Of what stands above a blade's edge, the share that is gone once the blade is past.
inline constexpr float kScraped = 0.97f;  // chosen by what strokes look like

/// 1 - (1 - frac)^lengths: turns a share per length into the share over `lengths` lengths. `frac`
/// is clamped to 0..1.
float share_over(float frac, double lengths);

/// The way that the stamp stands for, in diameters of the tip as it is pressed.
double travelled_diameters(const Stamp& stamp, const TipPose& pose);

/// Share of the wet paint under the tip that the bristles pick up where they hold fully (R22): the
/// slider's share, or the share that a rag absorbs if that is more.
float pickup_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose);

/// Share of the reservoir's paint that the palette replaces (R22); 0 for a tool that is not dipped.
float refill_share(const Stamp& stamp, const BrushDefinition& brush, const BrushSettings& settings,
                   const TipPose& pose);

/// Share of the difference between neighbouring layers that the brush mixes away (R28).
float mixing_share(const Stamp& stamp, const BrushSettings& settings, const TipPose& pose);

/// Share of the surplus that goes back to the canvas where the tip touches fully.
float return_share(const Stamp& stamp, const BrushDefinition& brush, const TipPose& pose);

/// Share of the paint above a blade's edge that the blade takes.
float scraped_share(const Stamp& stamp, const TipPose& pose);

}  // namespace pentimento
