#pragma once
// What a log holds, in numbers: for `pentimento info` and `validate`. One pass, memory bounded.

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/reader.h"

namespace pentimento::log {

/// Around all samples of touches (metres, y down); empty while min > max.
struct Bounds {
  double min_x_m = 1, min_y_m = 1, max_x_m = -1, max_y_m = -1;
  bool empty() const { return min_x_m > max_x_m; }
  void add(double x_m, double y_m);
};

struct Summary {
  /// Names in lists (marks, files) beyond this many are left out.
  static constexpr std::size_t kMaxNames = 1000;

  std::map<std::string, std::int64_t> events;  // per type; all x-... as "x-"
  std::int64_t event_count = 0;
  std::int64_t duration_us = 0;  // time of the last event
  std::int64_t strokes = 0;      // touches that went down
  std::int64_t cancelled = 0;    // ... and were cancelled
  int most_touches = 0;          // down at once
  int still_down = 0;            // at the end
  bool has_pressure = false, has_tilt = false, own_steps = false;
  Bounds bounds;
  std::set<std::string> pigments;            // of the palette, used by `color`
  std::set<Rgb> colors;                      // different picked colours
  std::vector<std::string> marks;            // in order
  std::set<std::string> files;               // named by events and header
  std::array<std::int64_t, 10> pressures{};  // samples with a pressure of 0 to 0.1, to 0.2, ... 1
  std::array<std::int64_t, 9> tilts{};       // leaning from upright by 0 to 10 degrees, ... 90
  std::string sha256, salvaged;

  double duration_s() const { return static_cast<double>(duration_us) / 1e6; }
};

/// Adds up events, one by one.
class Summarizer {
 public:
  explicit Summarizer(const Header& header);
  void add(const Event& event);
  /// The sum. `sha256` and `salvaged` are the reader's.
  Summary finish() const;

 private:
  Summary summary_;
  std::int64_t down_ = 0;
  std::vector<std::int64_t> counts_;  // per type
};

/// Reads from where `reader` stands (its first event) to the end. Errors: those of next().
Result<Summary> summarize(Reader& reader);

}  // namespace pentimento::log
