#pragma once
// What a film of a painting's making is asked to be.

#include <optional>

namespace pentimento {

/// Along what the frames are spread evenly.
enum class FilmAxis {
  kPainting,  // the time in which somebody paints; pauses are cut short
  kEvents,    // the samples of touches
  kWall       // the log's clock
};

struct FilmChoice {
  FilmAxis along = FilmAxis::kPainting;
  std::optional<int> frames;         // none: by the length
  std::optional<double> length_s;    // of the film
  std::optional<double> idle_cut_s;  // longer pauses take so much of the axis
  double frames_per_second = 25;
  bool any() const { return frames || length_s; }
};

}  // namespace pentimento
