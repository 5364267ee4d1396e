#pragma once
// What the painter sets about the brush: the sliders (R4) and the tip. Plain values.

#include <string>

#include "core/field.h"

namespace pentimento {

struct BrushSettings {
  float medium_frac = 0.5f;   // of max_medium, 0..1
  float pigment_frac = 0.7f;  // of max_pigment, 0..1
  float size_m = 0.03f;       // diameter, > 0
  float pickup = 0.3f;        // share of local paint lifted per diameter travelled, 0..1
  float refill = 0.05f;       // R22: share of the picked colour per 0.1 diameter, 0..1
  float stiffness = 0.5f;     // R23: with pressure, how deep the bristles reach, 0..1
  float layer_mixing = 0.3f;  // R28: per diameter travelled, 0..1
  float spacing = 0.025f;     // of stamps, in diameters, > 0
};

enum class TipShape { kRound, kFlat, kFilbert, kBristle, kKnife, kTexture };

/// A tip. `texture` is a grey map, 1 = most paint, only for kTexture; it covers the unit square.
struct BrushDefinition {
  std::string name = "round";
  TipShape shape = TipShape::kRound;
  Field<float> texture;
  float spacing = 0;               // 0: the slider's
  float size_pressure = 0.3f;      // how far pressure shrinks the size: size x (1 - this (1 - p))
  float flow_pressure = 1.0f;      // how far pressure scales the deposit
  bool follows_direction = false;  // the tip turns with the stroke (flat brushes of programs do)
};

}  // namespace pentimento
