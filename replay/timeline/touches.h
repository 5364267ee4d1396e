#pragma once
// The touches that are down, each with its path: samples of the log go in, stamps come out.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/brush/stroke_path.h"
#include "formats/log/tables/events.h"
#include "replay/timeline/cue_queue.h"

namespace pentimento {

struct CanvasSize {
  double width_m = 1, height_m = 1;
};

/// How the brush is set at a sample.
struct BrushSize {
  float diameter_m = 0.03f;
  double spacing_frac = 0.025;
};

/// A moment in the log: ordered by time, then by place among the events.
struct LogMoment {
  std::int64_t time_us = 0;
  std::int64_t place = 0;
};

/// One sample of the log with its place among the events.
struct PlacedTouch {
  const log::Touch& touch;
  LogMoment moment;
  std::int64_t line = 0;
};

class Touches {
 public:
  explicit Touches(const CanvasSize& canvas) : canvas_(canvas) {}

  /// A touch goes down that is played (not undone).
  void down(const PlacedTouch& at, const BrushSize& brush, std::uint32_t stroke_id, CueQueue& out);
  /// A touch moves, or lifts. Nothing happens if the touch is not down here, because it is undone.
  void move(const PlacedTouch& at, const BrushSize& brush, CueQueue& out);
  void up(const PlacedTouch& at, const BrushSize& brush, CueQueue& out);
  /// The log ends: all touches lift where they are.
  void end(CueQueue& out);

  /// The touches that are down send no more cues before this moment of the log. nullopt if no touch
  /// is down.
  std::optional<LogMoment> final_until() const;

 private:
  struct Down {
    std::int64_t id = 0;
    int slot = 0;
    StrokePath path;
    LogMoment begin, before, last;  // first sample, last but one, last
    std::int64_t line = 0;          // of the last sample
    float pressure = -1;            // of the last sample
  };
  Down* find(std::int64_t id);
  int free_slot() const;
  void emit(const Down& down, CueQueue& out);
  void finish(Down& down, CueQueue& out);

  CanvasSize canvas_;
  std::vector<Down> down_;
  std::vector<Stamp> stamps_;  // of one call, to save allocations
};

}  // namespace pentimento
