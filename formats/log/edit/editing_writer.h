#pragma once
// A writer of logs that edits what it is given.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/log/edit/event_filter.h"
#include "formats/log/edit/refit.h"
#include "formats/log/edit/spline_fit.h"
#include "formats/log/write/writer.h"

namespace pentimento::log {

/// Another log of the same canvas.
struct OtherLog {
  Header header;
  std::function<std::optional<Event>()> next;  // nothing at the end
  std::string file, sha256;                    // for the header: x-merged
};

/// What is done to a log, in this order.
struct Edits {
  std::optional<OtherLog> merged;
  std::vector<Event> gravity;                // replaces the log's, if there is any
  std::string gravity_file, gravity_sha256;  // for the header: x-gravity
  std::optional<std::pair<std::int64_t, std::int64_t>> trim_us;
  std::optional<std::int64_t> longest_idle_us;
  double speed = 1;                                   // > 0
  std::optional<double> resample_hz;                  // > 0
  std::optional<std::pair<double, double>> canvas_m;  // width, height
  double size_factor = 1;                             // > 0, on the sizes of brushes
  std::optional<SplineTolerance> spline;
};

/// Wraps `inner`, which gets header and events as they are after the edits.
class EditingWriter : public Writer {
 public:
  EditingWriter(Edits edits, std::unique_ptr<Writer> inner);
  void write(const Header& header) override;
  void write(const Event& event) override;
  /// Hands on what filters keep back, then ends the file. Errors: those of the file; kBadInput, if
  /// the other log's header cannot be merged.
  Result<Published> finish() override;

  /// What has been written: events; touches that went down, and their samples.
  std::int64_t events() const { return events_; }
  std::int64_t strokes() const { return strokes_; }
  std::int64_t samples() const { return samples_; }
  std::int64_t last_us() const { return last_us_; }

 private:
  template <typename Filter, typename... Arguments>
  void put_before(Arguments&&... arguments);
  EventSink first() const;
  void put(const Event& event);

  Edits edits_;
  std::optional<Error> problem_;  // what is written after it is lost
  std::unique_ptr<Writer> inner_;
  std::vector<std::unique_ptr<EventFilter>> filters_;  // the last one is the first to see an event
  std::int64_t events_ = 0, strokes_ = 0, samples_ = 0, last_us_ = 0;
};

}  // namespace pentimento::log
