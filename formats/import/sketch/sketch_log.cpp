#include "formats/import/sketch/sketch_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "formats/import/sketch/sketch_frame.h"
#include "formats/import/sketch/sketch_timing.h"
#include "formats/log/tables/ranges.h"
#include "formats/log/write/json_object.h"

namespace pentimento::sketch {

namespace {
constexpr double kDefaultWidthFrac = 0.01;  // of the longer side, where the source has no width
constexpr double kStrokesPerLength = 0.5;   // a second for half the longer side: a calm hand
constexpr int kMostAtOnce = 64;
constexpr double kToldCut_s = 0.05;       // less is told as 0.0
constexpr double kPaperFree = 0.9;        // reflectance of the paper where the source names none
constexpr double kCoveringPigment = 0.7;  // the slider's default: covers in one pass

/// The built-in brush of that shape.
const char* shape_of(BrushKind brush) {
  switch (brush) {
    case BrushKind::kFlat:
      return "flat";
    case BrushKind::kBristle:
      return "bristle";
    case BrushKind::kRigger:
      return "rigger";
    case BrushKind::kRound:
      break;
  }
  return "round";
}

bool is_pen(BrushKind brush) {
  return brush == BrushKind::kRound || brush == BrushKind::kRigger;
}

/// What the log calls the brush of a stroke: "pen", "fine pen 0.2", "flat 0.5".
std::string name_of(const Stroke& stroke) {
  std::string name = stroke.brush == BrushKind::kRound    ? "pen"
                     : stroke.brush == BrushKind::kRigger ? "fine pen"
                                                          : shape_of(stroke.brush);
  if (stroke.width_share_unpressed) name += fmt::format(" {:g}", *stroke.width_share_unpressed);
  return name;
}

/// The brushes that the log has to bring: pens, which never run dry, as what drew the recording
/// did not; and those whose width answers pressure in a way of their own.
std::vector<log::BrushSpec> brushes_of(const Sketch& sketch) {
  std::map<std::string, log::BrushSpec> out;
  for (const Item& item : sketch.items) {
    const auto* stroke = std::get_if<Stroke>(&item);
    if (stroke == nullptr || stroke->erases) continue;
    if (!is_pen(stroke->brush) && !stroke->width_share_unpressed) continue;
    log::BrushSpec& brush = out[name_of(*stroke)];
    brush.shape = shape_of(stroke->brush);
    if (is_pen(stroke->brush)) brush.capacity = log::kCapacityRange.max;
    if (stroke->width_share_unpressed) brush.size_pressure = 1 - *stroke->width_share_unpressed;
  }
  std::vector<log::BrushSpec> list;
  for (auto& [name, brush] : out) {
    brush.name = name;
    list.push_back(std::move(brush));
  }
  return list;
}

/// The slider `pigment` of paint of that opacity.
double pigment_of(double opacity) {
  return kCoveringPigment * std::clamp(opacity, 0.02, 1.0);
}

/// Sends events in the order of their times.
class EventWriter {
 public:
  EventWriter(const SketchFrame& frame, const TimingOptions& timing, log::Writer& writer)
      : frame_(frame), timing_(timing), writer_(writer) {}

  Result<LogCounts> write(const std::vector<TimedItem>& items) {
    for (const TimedItem& item : items) {
      advance(item.begin_s, false);
      if (const auto* stroke = std::get_if<Stroke>(item.item)) {
        if (down_.size() == kMostAtOnce)
          return Error{ErrorCode::kLimit,
                       fmt::format("more than {} strokes are painted at once", kMostAtOnce)};
        begin(item, *stroke);
      } else {
        advance(INFINITY, true);
        write_action(item);
      }
    }
    advance(INFINITY, true);
    counts_.duration_s = static_cast<double>(last_us_) * 1e-6;
    return counts_;
  }

 private:
  /// A stroke that is being painted.
  struct PaintedStroke {
    const TimedItem* timed = nullptr;
    const Stroke* stroke = nullptr;
    std::int64_t id = 0;
    std::size_t next = 0;  // sample
    double time_s = 0;     // of that sample
  };

  /// Writes what happens before `until_s`; with `end` all that is left.
  void advance(double until_s, bool end) {
    while (!down_.empty()) {
      auto soonest = std::min_element(
          down_.begin(), down_.end(),
          [&](const PaintedStroke& a, const PaintedStroke& b) { return a.time_s < b.time_s; });
      if (!end && !(soonest->time_s < until_s) && soonest->next < soonest->stroke->samples.size())
        return;
      write_next(*soonest);
      if (soonest->next > soonest->stroke->samples.size()) {
        ids_.erase(soonest->id);
        down_.erase(soonest);
      }
    }
  }

  void begin(const TimedItem& timed, const Stroke& stroke) {
    prepare(timed.begin_s, stroke);
    std::int64_t id = 0;
    while (ids_.count(id) != 0) ++id;
    ids_.insert(id);
    down_.push_back({&timed, &stroke, id, 0, timed.begin_s});
    ++counts_.strokes;
    counts_.samples += static_cast<std::int64_t>(stroke.samples.size());
    write_next(down_.back());
  }

  /// The next sample of a stroke; after the last one it goes up.
  void write_next(PaintedStroke& d) {
    const std::vector<Sample>& samples = d.stroke->samples;
    const bool up = d.next == samples.size();
    const Sample& s = samples[up ? d.next - 1 : d.next];
    log::Touch touch;
    touch.phase = up            ? log::TouchPhase::kUp
                  : d.next == 0 ? log::TouchPhase::kDown
                                : log::TouchPhase::kMove;
    touch.id = d.id;
    touch.x_m = on_canvas(s.x, frame_.x0);
    touch.y_m = on_canvas(s.y, frame_.y0);
    if (d.stroke->has_pressure) touch.pressure = std::clamp(rounded(s.pressure, 1e5), 0.0, 1.0);
    if (d.stroke->has_tilt) {
      touch.tilt_x_deg = std::clamp(rounded(s.tilt_x_deg, 100), -90.0, 90.0);
      touch.tilt_y_deg = std::clamp(rounded(s.tilt_y_deg, 100), -90.0, 90.0);
    }
    if (d.stroke->has_twist) touch.twist_deg = std::clamp(rounded(s.twist_deg, 100), -360.0, 360.0);
    send(d.time_s, touch);
    if (++d.next >= samples.size()) return;
    const Sample& following = samples[d.next];
    d.time_s = d.stroke->timed ? following.time_s + d.timed->shift_s
                               : d.time_s + std::hypot(following.x - s.x, following.y - s.y) /
                                                timing_.unit_per_s;
  }

  double on_canvas(double value, double origin) const {
    const log::Range& range = log::kPositionRange;
    return std::clamp(rounded((value - origin) * frame_.metre_per_unit, 1e7), range.min, range.max);
  }
  /// To that many parts of a unit: the log keeps short numbers.
  static double rounded(double value, double per_unit) {
    return std::round(value * per_unit) / per_unit;
  }

  /// Brush, size, colour and thinness, as far as they are others than before.
  void prepare(double time_s, const Stroke& stroke) {
    const std::string brush = stroke.erases ? "rag" : name_of(stroke);
    if (brush_ != brush) send(time_s, log::BrushChange{brush_ = brush});
    const double longer = std::max(frame_.canvas_width_m, frame_.canvas_height_m);
    const double width_m =
        stroke.width > 0 ? stroke.width * frame_.metre_per_unit : kDefaultWidthFrac * longer;
    const double size_m = std::clamp(rounded(width_m, 1e7), 1e-5, 0.5 * longer);
    if (size_m_ != size_m) send(time_s, log::Slider{"size", size_m_ = size_m});
    if (stroke.erases) return;
    if (!color_ || *color_ != stroke.color) {
      color_ = stroke.color;
      log::Color event;
      event.value = stroke.color;
      send(time_s, event);
    }
    const double pigment = pigment_of(stroke.opacity);
    if (pigment_ != pigment) send(time_s, log::Slider{"pigment", pigment_ = pigment});
  }

  void write_action(const TimedItem& item) {
    switch (std::get<SketchAction>(*item.item)) {
      case SketchAction::kDry:
        return send(item.begin_s, log::Dry{});
      case SketchAction::kClear:
        return send(item.begin_s, log::Clear{});
      case SketchAction::kUndo:
        return send(item.begin_s, log::Undo{});
      case SketchAction::kRedo:
        return send(item.begin_s, log::Redo{});
    }
  }

  void send(double time_s, log::Action action) {
    last_us_ = std::max(last_us_, static_cast<std::int64_t>(std::llround(time_s * 1e6)));
    log::Event event;
    event.time_us = last_us_;
    event.action = std::move(action);
    writer_.write(event);
    ++counts_.events;
  }

  const SketchFrame& frame_;
  const TimingOptions& timing_;
  log::Writer& writer_;
  LogCounts counts_;
  std::vector<PaintedStroke> down_;
  std::set<std::int64_t> ids_;
  std::int64_t last_us_ = 0;
  std::string brush_;
  double size_m_ = -1, pigment_ = kCoveringPigment;
  std::optional<log::Rgb> color_;
};

log::Header header_of(const Sketch& sketch, const SketchFrame& frame, const SketchOrigin& origin) {
  log::Header header;
  header.canvas_width_m = frame.canvas_width_m;
  header.canvas_height_m = frame.canvas_height_m;
  header.grid_width = frame.grid_width;
  header.grid_height = frame.grid_height;
  header.paper.reflectance = sketch.paper.value_or(log::Rgb{kPaperFree, kPaperFree, kPaperFree});
  header.brushes = brushes_of(sketch);
  header.title = sketch.title;
  header.author = sketch.author;
  header.recorded_by = sketch.recorded_by;
  header.recorded_at = sketch.recorded_at;
  log::JsonObject source;
  source.text("format", origin.format).text("file", origin.file).text("sha256", origin.sha256);
  header.extensions = "\"x-source\":" + source.close();
  return header;
}
}  // namespace

Result<LogCounts> write_log(const Sketch& sketch, const SketchOrigin& origin,
                            const LogOptions& options, log::Writer& writer) {
  const Result<SketchFrame> frame = frame_of(sketch, options.cells);
  if (!frame) return frame.error();
  TimingOptions timing;
  timing.longest_pause_s = options.longest_pause_s;
  timing.unit_per_s = kStrokesPerLength / frame->metre_per_unit;
  const Timetable timetable = time_items(sketch, timing);
  writer.write(header_of(sketch, *frame, origin));
  Result<LogCounts> counts = EventWriter(*frame, timing, writer).write(timetable.items);
  if (!counts) return counts;
  counts->canvas_width_m = frame->canvas_width_m;
  counts->canvas_height_m = frame->canvas_height_m;
  counts->report = sketch.report;
  if (timetable.waiting > 0)
    counts->report.guessed.push_back(fmt::format(
        "times of {} strokes that wait for another, which looks otherwise", timetable.waiting));
  if (timetable.cut_s >= kToldCut_s)
    counts->report.dropped.push_back(fmt::format("{:.1f} s of pauses longer than {} s",
                                                 timetable.cut_s, options.longest_pause_s));
  return counts;
}

}  // namespace pentimento::sketch
