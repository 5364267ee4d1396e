#pragma once
// The tuft: a bundle of bristles, and the mark that it makes on the canvas, from a touch of the
// longest bristles to the whole bundle pressed down. After DiVerdi, Krishnaswamy, Hadap
// (Industrial-strength painting with a virtual bristle brush, VRST 2010), reduced to what a height
// field can show. A bristle is a point with a place, a length, a thickness and a load. Pressing
// brings shorter bristles down, spreads their feet and bends them back along the stroke. All
// lengths are in halves of the diameter.

#include <cstdint>
#include <vector>

#include "core/base/field.h"
#include "core/brush/brush_settings.h"

namespace pentimento {

/// How bristles are bound.
struct Tuft {
  float half_u = 0.5f, half_v = 0.9f;  // of the bundle, along and across the stroke
  float corner = 0;                    // 0 an ellipse, 1 a rectangle
  float point = 0;                     // how much shorter the bristles at the rim are
  float film = 0;                      // paint between the bristles, share of theirs
  float ridge = 0;                     // how much more the bristles at the sides carry
  float drag = 0;                      // how far the bristles trail when pressed down
  BristleSet bristles;
};

/// The tuft of a shape; for kTexture it fills the square. Knife and rag have no bristles.
Tuft tuft_of(TipShape shape);

struct Bristle {
  float u = 0, v = 0;          // its foot, unpressed
  float out_u = 0, out_v = 0;  // where its clump spreads to
  float length = 0;            // the longest is 1
  float radius = 0;            // of its mark
  float load = 0;              // (0,1]
};

/// The bristles of a tuft; `seed` chooses them.
std::vector<Bristle> make_bristles(const Tuft& tuft, std::uint64_t seed);

/// The mark of a tuft at `press` in [0,1], as a `size` x `size` map over the tip's square.
Field<float> draw_tuft(const Tuft& tuft, const std::vector<Bristle>& bristles, float press,
                       int size);

}  // namespace pentimento
