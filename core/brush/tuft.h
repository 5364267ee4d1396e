#pragma once
// A bundle of bristles and the mark it makes on the canvas, from a touch of its longest bristles to
// the whole bundle pressed down. After DiVerdi, Krishnaswamy, Hadap (Industrial-strength painting
// with a virtual bristle brush, VRST 2010), reduced to what a height field can show: bristles are
// points with a place, a length, a thickness and a load; pressing brings shorter ones down, spreads
// their feet and bends them back along the stroke. All lengths in halves of the diameter.

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
  float film = 0;                      // paint between the bristles, of theirs
  float ridge = 0;                     // how much more the bristles at the sides carry
  float drag = 0;                      // how far they trail when pressed down
  BristleSet bristles;
};

/// The bundle of a shape; of kTexture one that fills the square. Knife and rag have none.
Tuft tuft_of(TipShape shape);

struct Bristle {
  float u = 0, v = 0;          // its foot, unpressed
  float out_u = 0, out_v = 0;  // where its clump spreads to
  float length = 0;            // the longest is 1
  float radius = 0;            // of its mark
  float load = 0;              // (0,1]
};

/// The bristles of a bundle; `seed` chooses them.
std::vector<Bristle> make_bristles(const Tuft& tuft, std::uint64_t seed);

/// The bundle's mark at `press` in [0,1] as a `size` x `size` map over the tip's square.
Field<float> draw_tuft(const Tuft& tuft, const std::vector<Bristle>& bristles, float press,
                       int size);

}  // namespace pentimento
