#pragma once
// Two logs of one canvas become one, as two hands that paint side by side.

#include <array>
#include <functional>
#include <optional>
#include <set>

#include "formats/log/edit/event_filter.h"
#include "formats/log/edit/hand_settings.h"

namespace pentimento::log {

/// Puts the events of another log between those that it takes, by their times. Touches get ids of
/// their own. Brush, sliders of the brush and colours are each hand's own: they are sent when the
/// hand goes down after the other one painted. A hand that would paint with other settings while
/// the other hand is down waits until that is up, and goes on from there with its pauses as they
/// were. Of gravity, light, environment and camera the log's own hold, the other's are left out.
class MergeLog : public EventFilter {
 public:
  /// The other log's next event; nothing at its end.
  using OtherEvents = std::function<std::optional<Event>()>;

  MergeLog(const Header& header, const Header& other_header, OtherEvents other, EventSink next);
  void take(const Event& event) override;
  void finish() override;

 private:
  struct HandState {
    HandSettings settings;
    std::set<std::int64_t> down;
    std::int64_t delay_us = 0;
  };

  bool must_wait(std::size_t hand, const Event& event) const;
  void send(std::size_t hand, Event event);
  void send_other_until(std::int64_t time_us);
  void lift_other(std::int64_t time_us);
  void send_next_of_other();

  std::array<HandState, 2> hands_;
  HandSettings in_force_;
  OtherEvents other_;
  std::optional<Event> waiting_;
  bool begun_ = false;
  std::int64_t now_us_ = 0;
};

}  // namespace pentimento::log
