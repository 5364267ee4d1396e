#pragma once
// What the painter sets about a brush: the sliders (R4) and the tip. Plain values.

#include <string>

#include "core/base/field.h"
#include "core/brush/pressure_curve.h"

namespace pentimento {

struct BrushSettings {
  float medium_frac = 0.5f;   // slider, share of film_medium in one pass, 0..1
  float pigment_frac = 0.7f;  // slider, share of film_pigment in one pass, 0..1
  float size_m = 0.03f;       // diameter, > 0
  float pickup = 0.3f;        // share of the paint under it picked up per diameter, 0..1
  float refill = 0.05f;       // R22: share that the palette replaces per 0.1 diameter, 0..1
  float stiffness = 0.5f;     // R23: with the pressure, the penetration, 0..1
  float layer_mixing = 0.3f;  // R28: share mixed per diameter travelled, 0..1
  float spacing = 0.025f;     // of stamps, in diameters, > 0
  float load_frac = 1.0f;     // R24: how full the brush is when it touches down, 0..1
};

enum class TipShape { kRound, kFlat, kFilbert, kBristle, kKnife, kTexture, kFan, kRigger, kRag };

/// The bristles of a tip. Lengths are in halves of the diameter.
struct BristleSet {
  int count = 0;            // 0: the tip has no bristles, it is a map
  float thickness = 0.05f;  // radius of a bristle's mark, > 0
  float length_spread = 0;  // how unequal the lengths are, 0..1; long ones touch first
  float clumping = 0;       // how far bristles stick together, 0..1
  bool operator==(const BristleSet&) const = default;
};

/// A brush: its tip, and how the tip acts. `texture` is for kTexture only: a grey map over the unit
/// square, in [0,1], 1 = most paint.
struct BrushDefinition {
  std::string name = "round";
  TipShape shape = TipShape::kRound;
  Field<float> texture;
  BristleSet bristles;
  float spacing = 0;               // in diameters; 0: the slider's
  float size_pressure = 0.3f;      // s: at pressure p the size is 1 - s (1 - p)
  float flow_pressure = 1.0f;      // f: at pressure p the deposit is 1 - f (1 - p)
  bool follows_direction = false;  // the tip turns with the stroke (flat brushes of programs do)
  PressureCurve size;              // if there is one, in place of size_pressure
  PressureCurve flow;              // if there is one, in place of flow_pressure
  PressureCurve splay;             // press of the bristles at a pressure, 0..1
  float stiffness = -1;            // 0..1 in place of the slider's; negative: the slider's
  float grip = 1;                  // how unevenly bristles hold the paint that they meet, 0..1
  float capacity = 200;            // R24: diameters on dry canvas that empty a full brush
  float film = 1;                  // share of the sliders' film it deposits; 0: nothing
  float absorb = 0;                // share of the paint under it that a rag keeps, per diameter
  bool scrapes = false;            // a blade: it takes what stands above its edge

  /// It is dipped into paint; else, as a knife or a rag, it starts clean and lays what it took up.
  bool lays_paint() const { return film > 0; }

  /// Pressed down without being drawn, its bristles spread to all sides; others keep to a line.
  bool spreads_all_round() const { return shape == TipShape::kRound || shape == TipShape::kRigger; }

  /// Factors on the size and on the deposit at a pressure in [0,1].
  float size_at(float pressure) const {
    return size.empty() ? 1 - size_pressure * (1 - pressure) : size.at(pressure);
  }
  float flow_at(float pressure) const {
    return flow.empty() ? 1 - flow_pressure * (1 - pressure) : flow.at(pressure);
  }
  /// How far the bristles are pressed down at a pressure in [0,1]. Soft at first: half of the
  /// pressure presses three quarters of the bristles down.
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
