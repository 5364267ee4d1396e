// W3C Ink Markup Language. Source: W3C Recommendation "Ink Markup Language (InkML)", 2011.
// Kept: places (x right, y down), force, tip switch, tilt by either kind of angles, rotation, time,
// width, colour, transparency, continued traces, traces in the air (left out). Guessed: azimuth
// counts clockwise from the right, as in Pointer Events; force without a declared maximum is scaled
// by the greatest one. Dropped: colour per point, trace views, annotations.
// Lengths become metres where the channels have units or a resolution, else they stay as they are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <tuple>
#include <unordered_map>

#include "formats/import/read/inkml_context.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/pen_angles.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr double kRadian_deg = 57.29577951308232;
constexpr int kDeepestGroup = 64;
constexpr double kLift_s = 0.2;  // between traces that each count from 0

class InkmlReader {
 public:
  explicit InkmlReader(const Source& source) : source_(source) {}

  Result<Sketch> read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(source_.bytes.data(), source_.bytes.size());
    if (!parsed) return bad(static_cast<long>(parsed.offset), parsed.description());
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "ink") return bad(0, "the root is not <ink>");
    definitions_.emplace(root);
    read_group(root, {}, 0);
    if (error_) return *error_;
    finish();
    return std::move(sketch_);
  }

 private:
  Error bad(long offset, std::string_view what, ErrorCode code = ErrorCode::kBadInput) const {
    return {code, fmt::format("{}: offset {}: {}", source_.name, offset, what)};
  }
  void fail(const pugi::xml_node& node, std::string_view what,
            ErrorCode code = ErrorCode::kBadInput) {
    if (!error_) error_ = bad(static_cast<long>(node.offset_debug()), what, code);
  }
  bool apply(const pugi::xml_node& node, InkmlContext& context) {
    if (!definitions_->apply(node, context)) fail(node, "references in a circle");
    return !error_;
  }

  /// The traces of <ink> or of a group, with what holds for them.
  void read_group(const pugi::xml_node& group, InkmlContext context, int depth) {
    if (depth > kDeepestGroup)
      return fail(group, fmt::format("groups within more than {} others", kDeepestGroup),
                  ErrorCode::kLimit);
    for (const pugi::xml_node& node : group.children()) {
      const std::string_view name = local_name(node);
      if (name == "context" || name == "traceFormat" || name == "brush") {
        apply(node, context);  // holds from here on
      } else if (name == "trace") {
        InkmlContext own = context;
        if (apply(node, own)) read_trace(node, own);
      } else if (name == "traceGroup") {
        InkmlContext own = context;
        if (apply(node, own)) read_group(node, own, depth + 1);
      } else if (name == "traceView") {
        ++views_;
      }
      if (error_) return;
    }
  }

  void read_trace(const pugi::xml_node& node, const InkmlContext& context) {
    if (std::string_view(node.attribute("type").value()) == "penUp") {
      ++hovers_;
      return;
    }
    // Comments and entities may part the text.
    std::string text;
    for (const pugi::xml_node& child : node.children())
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
        text += child.value();
    const auto points = inkml_points(text, context.channels);
    if (!points) return fail(node, points.error().message);
    if (points->empty()) return;
    const auto at = [&](std::string_view name) { return index_of(context, name); };
    if (at("X") < 0 || at("Y") < 0) return fail(node, "the format has no channel X or Y");
    Stroke stroke = stroke_of(context);
    for (const std::vector<double>& values : *points) {
      // A pen that is up parts the trace.
      if (at("S") >= 0 && values[static_cast<std::size_t>(at("S"))] == 0) {
        if (!stroke.samples.empty() && !add(node, stroke)) return;
        stroke.samples.clear();
        continue;
      }
      stroke.samples.push_back(sample_of(context, values));
      if (const int w = at("W"); w >= 0)
        stroke.width = std::max(stroke.width, std::abs(scaled(context, values, w)));
    }
    if (stroke.samples.empty()) return;
    add(node, stroke);
  }

  static int index_of(const InkmlContext& context, std::string_view name) {
    for (std::size_t i = 0; i < context.channels.size(); ++i)
      if (context.channels[i].name == name) return static_cast<int>(i);
    return -1;
  }
  static double scaled(const InkmlContext& context, const std::vector<double>& values, int i) {
    const auto k = static_cast<std::size_t>(i);
    return values[k] * context.channels[k].factor;
  }

  Stroke stroke_of(const InkmlContext& context) const {
    const auto has = [&](const char* name) { return index_of(context, name) >= 0; };
    Stroke stroke;
    stroke.timed = has("T");
    stroke.has_pressure = has("F") && !context.brush.ignores_pressure;
    stroke.has_tilt = (has("OTx") && has("OTy")) || (has("OA") && has("OE"));
    stroke.has_twist = has("OR");
    stroke.color = context.brush.color;
    stroke.opacity = context.brush.opacity;
    stroke.brush = context.brush.kind;
    // A width in metres beside places without a unit says nothing, and the other way about.
    const int x = index_of(context, "X");
    const bool in_metres = x >= 0 && context.channels[static_cast<std::size_t>(x)].has_length;
    if (context.brush.width_has_length == in_metres && !has("W"))
      stroke.width = context.brush.width;
    return stroke;
  }

  Sample sample_of(const InkmlContext& context, const std::vector<double>& values) {
    const auto value = [&](const char* name) {
      const int i = index_of(context, name);
      return i < 0 ? 0.0 : scaled(context, values, i);
    };
    Sample s;
    s.x = value("X");
    s.y = value("Y");
    s.time_s = value("T");
    if (const int f = index_of(context, "F"); f >= 0)
      s.pressure = force_of(context.channels[static_cast<std::size_t>(f)],
                            values[static_cast<std::size_t>(f)]);
    if (index_of(context, "OTx") >= 0 && index_of(context, "OTy") >= 0) {
      s.tilt_x_deg = static_cast<float>(std::clamp(value("OTx"), -90.0, 90.0));
      s.tilt_y_deg = static_cast<float>(std::clamp(value("OTy"), -90.0, 90.0));
    } else if (index_of(context, "OA") >= 0 && index_of(context, "OE") >= 0) {
      std::tie(s.tilt_x_deg, s.tilt_y_deg) =
          tilts_deg(value("OE") / kRadian_deg, value("OA") / kRadian_deg);
    }
    s.twist_deg = static_cast<float>(std::fmod(value("OR"), 360.0));
    return s;
  }

  /// 0..1 where the channel has a range; else as it is, until all are known.
  float force_of(const InkmlChannel& channel, double value) {
    if (channel.most > channel.least) {
      const double frac = (value - channel.least) / (channel.most - channel.least);
      return static_cast<float>(std::clamp(frac, 0.0, 1.0));
    }
    most_force_ = std::max(most_force_, value);
    return static_cast<float>(std::clamp(value, 0.0, 1e12));
  }

  /// Sets the times of a trace and keeps it, or hangs it on the one that it continues.
  bool add(const pugi::xml_node& node, Stroke stroke) {
    const std::optional<double> offset_ms = number_of(node.attribute("timeOffset").value());
    const std::optional<double> duration_ms = number_of(node.attribute("duration").value());
    spread_duration(stroke, duration_ms);
    if (stroke.timed) {
      double shift_s = std::clamp(offset_ms.value_or(0), -1e15, 1e15) * 1e-3;
      if (!offset_ms && stroke.samples.front().time_s == 0 && last_s_ > 0) {
        shift_s = last_s_ + kLift_s;
        ++from_zero_;
      }
      double before_s = -INFINITY;
      for (Sample& s : stroke.samples) {
        s.time_s += shift_s;
        if (s.time_s < before_s) {
          fail(node, fmt::format("time {:.9g} s runs back from {:.9g} s", s.time_s, before_s));
          return false;
        }
        before_s = s.time_s;
      }
      last_s_ = std::max(last_s_, before_s);
    }
    any_color_ |= stroke.color != log::Rgb{0, 0, 0};
    any_width_ |= stroke.width > 0;
    any_pressure_ |= stroke.has_pressure;
    any_tilt_ |= stroke.has_tilt;
    any_time_ |= stroke.timed;
    keep(node, std::move(stroke));
    return true;
  }

  /// A trace that has a duration alone was painted evenly.
  static void spread_duration(Stroke& stroke, std::optional<double> duration_ms) {
    if (stroke.timed || !duration_ms || !(*duration_ms > 0 && *duration_ms < 1e12)) return;
    const double count = static_cast<double>(std::max<std::size_t>(stroke.samples.size() - 1, 1));
    for (std::size_t i = 0; i < stroke.samples.size(); ++i)
      stroke.samples[i].time_s = *duration_ms * 1e-3 * static_cast<double>(i) / count;
    stroke.timed = true;
  }

  void keep(const pugi::xml_node& node, Stroke stroke) {
    const char* id =
        node.attribute("xml:id") ? node.attribute("xml:id").value() : node.attribute("id").value();
    std::string_view prior = node.attribute("priorRef").value();
    if (prior.starts_with('#')) prior.remove_prefix(1);
    const auto before = ends_.find(std::string(prior));
    if (!node.attribute("continuation").empty() && before != ends_.end()) {
      auto& whole = std::get<Stroke>(sketch_.items[before->second]);
      const bool fits =
          whole.timed == stroke.timed && whole.has_pressure == stroke.has_pressure &&
          (!whole.timed || whole.samples.back().time_s <= stroke.samples.front().time_s);
      if (fits) {
        whole.samples.insert(whole.samples.end(), stroke.samples.begin(), stroke.samples.end());
        ends_[id] = before->second;
        return;
      }
    }
    if (*id != 0) ends_[id] = sketch_.items.size();
    sketch_.items.push_back(std::move(stroke));
  }

  /// Scales forces without a range, and reports.
  void finish() {
    if (most_force_ > 1) {
      for (Item& item : sketch_.items)
        for (Sample& s : std::get<Stroke>(item).samples)
          s.pressure = std::min(1.0f, s.pressure / static_cast<float>(most_force_));
      sketch_.report.guessed.push_back("pressure 1 is the greatest force");
    }
    sketch_.report.kept = {"places"};
    if (any_color_) sketch_.report.kept.push_back("colour");
    if (any_width_) sketch_.report.kept.push_back("width");
    if (any_time_) sketch_.report.kept.push_back("times");
    if (any_pressure_) sketch_.report.kept.push_back("pressure");
    if (any_tilt_) sketch_.report.kept.push_back("tilt");
    if (!any_time_) sketch_.report.guessed.push_back("times, of which there are none");
    const auto report = [](std::vector<std::string>& list, int count, std::string_view what) {
      if (count > 0) list.push_back(fmt::format("{} {}", count, what));
    };
    report(sketch_.report.guessed, from_zero_, "traces that count from 0 follow the one before");
    report(sketch_.report.dropped, hovers_, "traces in the air");
    report(sketch_.report.dropped, views_, "trace views");
  }

  const Source& source_;
  std::optional<InkmlDefinitions> definitions_;
  Sketch sketch_;
  std::optional<Error> error_;
  std::unordered_map<std::string, std::size_t> ends_;  // id of a trace to the stroke it is part of
  double most_force_ = 0, last_s_ = 0;
  int hovers_ = 0, views_ = 0, from_zero_ = 0;
  bool any_color_ = false, any_width_ = false;
  bool any_pressure_ = false, any_tilt_ = false, any_time_ = false;
};
}  // namespace

bool is_inkml(std::string_view bytes) {
  std::string_view rest = without_bom(bytes);
  while (true) {
    const std::size_t begin = rest.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || rest[begin] != '<') return false;
    rest.remove_prefix(begin + 1);
    const bool comment = rest.starts_with("!--");
    if (!comment && !rest.starts_with('?') && !rest.starts_with('!')) break;
    const std::string_view end = comment ? "-->" : ">";
    const std::size_t at = rest.find(end);
    if (at == std::string_view::npos) return false;
    rest.remove_prefix(at + end.size());
  }
  const std::string_view tag = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
  return tag == "ink" || tag.ends_with(":ink");
}

Result<Sketch> read_inkml(const Source& source, const ReadOptions&) {
  return InkmlReader(source).read();
}

}  // namespace pentimento::sketch
