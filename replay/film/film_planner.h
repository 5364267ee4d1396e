#pragma once
// Chooses the steps that the frames of a film show, from the events of a log.

#include <cstdint>
#include <set>
#include <vector>

#include "formats/log/tables/events.h"
#include "replay/job/film_choice.h"
#include "replay/job/step_clock.h"

namespace pentimento {

class FilmPlanner {
 public:
  /// `stepped`: the log has `step` events and is stepped by them alone.
  FilmPlanner(double steps_per_second, bool stepped)
      : clock_(steps_per_second), stepped_(stepped) {}

  /// Feeds the log, event by event.
  void add(const log::Event& event);
  /// The steps done at each frame: not decreasing, the last is `steps`, which the log has in all.
  /// Frame i of n shows the share (i + 1) / n of the axis.
  std::vector<std::int64_t> frames(const FilmChoice& choice, std::int64_t steps) const;

 private:
  /// Steps from..to in which a touch is down, or in which the canvas changes at once.
  struct Busy {
    std::int64_t from = 0, to = 0;
  };
  /// A point of the axis and the step there.
  struct FilmKnot {
    double at = 0;
    double step = 0;
  };
  void busy_until(std::int64_t step);
  std::vector<FilmKnot> knots(const FilmChoice& choice, std::int64_t steps) const;
  int frame_count(const FilmChoice& choice, double axis_steps) const;

  StepClock clock_;
  bool stepped_;
  std::int64_t step_ = 0;  // of the last event
  std::set<std::int64_t> down_;
  std::vector<Busy> busy_;
  std::vector<std::int64_t> samples_;  // steps of the samples of touches
};

}  // namespace pentimento
