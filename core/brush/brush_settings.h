#pragma once
// What the painter sets about the brush: the sliders (R4) and the tip. Plain values.

#include <string>

#include "core/base/field.h"
#include "core/brush/pressure_curve.h"

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
  float load_frac = 1.0f;     // R24: how full the brush is when it touches down, 0..1
};

enum class TipShape { kRound, kFlat, kFilbert, kBristle, kKnife, kTexture, kFan, kRigger, kRag };

/// The bristles of a tip. Lengths are in halves of the diameter.
struct BristleSet {
  int count = 0;            // 0: none, the tip is a map
  float thickness = 0.05f;  // radius of a bristle's mark, > 0
  float length_spread = 0;  // how unequal their lengths are, 0..1: the longest touch first
  float clumping = 0;       // how far they stick together, 0..1
  bool operator==(const BristleSet&) const = default;
};

/// A tip. `texture` is a grey map, 1 = most paint, only for kTexture; it covers the unit square.
struct BrushDefinition {
  std::string name = "round";
  TipShape shape = TipShape::kRound;
  Field<float> texture;
  BristleSet bristles;
  float spacing = 0;               // 0: the slider's
  float size_pressure = 0.3f;      // how far pressure shrinks the size: size x (1 - this (1 - p))
  float flow_pressure = 1.0f;      // how far pressure scales the deposit
  bool follows_direction = false;  // the tip turns with the stroke (flat brushes of programs do)
  PressureCurve size;              // in place of size_pressure: times the size
  PressureCurve flow;              // in place of flow_pressure: times the deposit
  PressureCurve splay;             // how far the bristles are pressed down, 0..1
  float stiffness = -1;            // 0..1 in place of the slider's; negative: the slider's
  float grip = 1;                  // how unevenly the bristles hold the paint they meet, 0..1
  float capacity = 200;            // R24: diameters on dry canvas that empty a full brush
  float film = 1;                  // of the sliders' film, that it lays; 0: it lays nothing
  float absorb = 0;                // share of the paint under it that a rag keeps, per diameter
  bool scrapes = false;            // a blade: takes what stands above its edge

  /// It is dipped into paint; else, as a knife or a rag, it starts clean and lays what it took up.
  bool lays_paint() const { return film > 0; }
  float size_at(float pressure) const {
    return size.empty() ? 1 - size_pressure * (1 - pressure) : size.at(pressure);
  }
  float flow_at(float pressure) const {
    return flow.empty() ? 1 - flow_pressure * (1 - pressure) : flow.at(pressure);
  }
  /// Soft at first: half the pressure presses three quarters of the bristles down.
  float splay_at(float pressure) const {
    return splay.empty() ? 1 - (1 - pressure) * (1 - pressure) : splay.at(pressure);
  }
  BrushDefinition clone() const;
};

inline BrushDefinition BrushDefinition::clone() const {
  BrushDefinition copy;
  copy.name = name;
  copy.shape = shape;
  copy.texture = texture.clone();
  copy.bristles = bristles;
  copy.spacing = spacing;
  copy.size_pressure = size_pressure;
  copy.flow_pressure = flow_pressure;
  copy.follows_direction = follows_direction;
  copy.size = size;
  copy.flow = flow;
  copy.splay = splay;
  copy.stiffness = stiffness;
  copy.grip = grip;
  copy.capacity = capacity;
  copy.film = film;
  copy.absorb = absorb;
  copy.scrapes = scrapes;
  return copy;
}

}  // namespace pentimento
