#pragma once
// Strokes of Wacom's Universal Ink Model with samples at their places.

#include "formats/import/sketch/sketch.h"
#include "formats/import/wacom/uim_ink.h"

namespace pentimento::sketch {

/// Adds a stroke for each that has a spline. Places are the spline's: what was written is often
/// moved afterwards, and sensors do not know. Sample i lies at spline point i + 3 where the spline
/// has five points more, as it has if nothing cut it; else the sensor's path is shifted onto the
/// spline's middle. Strokes without a sensor have the spline's points and no times.
void add_uim_strokes(const UimInk& ink, Sketch& sketch);

}  // namespace pentimento::sketch
