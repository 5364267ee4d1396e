#pragma once
// When the strokes of a sketch are painted in the log.

#include <vector>

#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// A stroke or action of a sketch, and when it begins.
struct TimedItem {
  const Item* item = nullptr;
  double begin_s = 0;  // of the log
  double shift_s = 0;  // log time less the samples' own, for strokes that are timed
  double end_s = 0;
};

struct TimingOptions {
  double longest_pause_s = 10;  // longer ones are cut to this
  double unit_per_s = 1;        // speed of strokes without times
};

/// When all is painted, and what of the source's times was given up for it.
struct Timetable {
  std::vector<TimedItem> items;
  double cut_s = 0;  // of pauses that were longer than the longest
  int waiting = 0;   // strokes that overlapped another which looks otherwise, and now follow it
};

/// The items in the order of their beginnings, from 0. Between two actions strokes are ordered by
/// their own times. Strokes that overlap keep that, if they look alike: what a stroke is painted
/// with holds for all that are painted at once. Strokes without times follow one another.
Timetable time_items(const Sketch& sketch, const TimingOptions& options);

/// Whether two strokes are painted with the same brush, colour, width and opacity.
bool same_settings(const Stroke& a, const Stroke& b);

}  // namespace pentimento::sketch
