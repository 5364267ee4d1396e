#pragma once
// A log in memory, for tests.

#include <optional>
#include <utility>
#include <vector>

#include "formats/log/reader.h"

namespace pentimento::test {

class ListReader : public log::Reader {
 public:
  log::Header head;
  std::vector<log::Event> events;

  void add(double t, log::Action action) {
    log::Event event;
    event.time_us = static_cast<std::int64_t>(t * 1e6 + 0.5);
    event.line = static_cast<std::int64_t>(events.size()) + 2;
    event.action = std::move(action);
    events.push_back(std::move(event));
  }
  void touch(double t, log::TouchPhase phase, double x, double y, std::int64_t id = 0) {
    log::Touch touch;
    touch.phase = phase;
    touch.id = id;
    touch.x_m = x;
    touch.y_m = y;
    add(t, touch);
  }
  /// A straight stroke of `samples` + 1 samples.
  void stroke(double t0, double t1, double x0, double x1, double y, int samples = 4,
              std::int64_t id = 0) {
    for (int i = 0; i <= samples; ++i) {
      const double u = static_cast<double>(i) / samples;
      const auto phase = i == 0         ? log::TouchPhase::kDown
                         : i == samples ? log::TouchPhase::kUp
                                        : log::TouchPhase::kMove;
      touch(t0 + (t1 - t0) * u, phase, x0 + (x1 - x0) * u, y, id);
    }
  }

  const log::Header& header() const override { return head; }
  Result<std::optional<log::Event>> next() override {
    if (at_ == events.size()) return std::optional<log::Event>{};
    return std::optional<log::Event>{events[at_++]};
  }
  Result<void> rewind() override {
    at_ = 0;
    return {};
  }
  std::string sha256() const override { return "test"; }
  std::string salvaged() const override { return {}; }

 private:
  std::size_t at_ = 0;
};

}  // namespace pentimento::test
