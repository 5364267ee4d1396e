// Excalidraw's scenes and libraries (JSON), and bare rows [x, y, pressure, milliseconds] of the
// same pen strokes. Places in CSS pixels, y down.
// Source: github.com/excalidraw/excalidraw, packages/element/src/types.ts; the rows are the samples
// of github.com/steveruizok/perfect-freehand. Kept: free-hand strokes in their order, places,
// rotation, pressure, colour, opacity, width, paper colour; times of bare rows. Guessed: times of
// scenes, which hold none per point. Dropped: shapes, texts and what is deleted.
// The items of a library have places of their own, often one on another: they are laid out in rows.

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <cmath>

#include "formats/import/read/css_color.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
namespace dom = simdjson::dom;

constexpr double kDrawnPerStrokeWidth = 4.25;  // Excalidraw draws strokeWidth 1 that wide
constexpr double kMost = 1e9;                  // of a place, in pixels: more is damage
constexpr double kGap_px = 20;                 // between the items of a library
constexpr float kNoSensor = 0.5f;              // the pressure of devices that feel none
constexpr std::string_view kBlank = " \t\r\n";

struct Box {
  double left = kMost * 4, top = kMost * 4, right = -kMost * 4, bottom = -kMost * 4;
  void add(double x, double y) {
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

Box box_of(const std::vector<Sample>& samples) {
  Box box;
  for (const Sample& s : samples) box.add(s.x, s.y);
  return box;
}

void rotate(std::vector<Sample>& samples, double angle_rad) {
  if (angle_rad == 0) return;
  const Box box = box_of(samples);
  const double x0 = (box.left + box.right) / 2, y0 = (box.top + box.bottom) / 2;
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (Sample& sample : samples) {
    const double x = sample.x - x0, y = sample.y - y0;
    sample.x = x0 + x * c - y * s;
    sample.y = y0 + x * s + y * c;
  }
}

class ExcalidrawReader {
 public:
  explicit ExcalidrawReader(const Source& source) : source_(source) {}

  Result<Sketch> read() {
    const std::string_view text = without_bom(source_.bytes);
    dom::parser parser;
    dom::element root;
    if (const auto problem = parser.parse(text.data(), text.size()).get(root))
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}: not JSON: {}", source_.name, simdjson::error_message(problem))};
    dom::array rows;
    if (root.get_array().get(rows) == simdjson::SUCCESS)
      read_rows(rows);
    else
      read_scene(root);
    if (!problem_.empty())
      return Error{ErrorCode::kBadInput, fmt::format("{}: {}", source_.name, problem_)};
    return std::move(sketch_);
  }

 private:
  void fail(std::string_view what) {
    if (problem_.empty()) problem_ = fmt::format("{}: {}", place_, what);
  }
  bool ok() const { return problem_.empty(); }

  /// A number within +-most; `otherwise`, where there is no such member.
  double member(dom::element in, const char* key, double otherwise, double most) {
    dom::element value;
    if (in[key].get(value) != simdjson::SUCCESS) return otherwise;
    return number(value, key, -most, most);
  }
  double number(dom::element value, std::string_view name, double least, double most) {
    double out = 0;
    if (value.get_double().get(out) != simdjson::SUCCESS)
      fail(fmt::format("{} is not a number", name));
    else if (!(out >= least && out <= most))
      fail(fmt::format("{} {} is outside {}..{}", name, out, least, most));
    return ok() ? out : 0;
  }

  void read_rows(dom::array rows) {
    Stroke stroke;
    stroke.timed = true;
    double last_s = -kMost;
    int row_number = 0;
    for (const dom::element element : rows) {
      place_ = fmt::format("row {}", ++row_number);
      dom::array row;
      if (element.get_array().get(row) != simdjson::SUCCESS || row.size() != 4)
        return fail("a row is [x, y, pressure, milliseconds]");
      Sample s;
      s.x = number(row.at(0).value_unsafe(), "x", -kMost, kMost);
      s.y = number(row.at(1).value_unsafe(), "y", -kMost, kMost);
      s.pressure = static_cast<float>(number(row.at(2).value_unsafe(), "pressure", 0, 1));
      // Epoch milliseconds are allowed: 1e14 ms is the year 5138.
      s.time_s = number(row.at(3).value_unsafe(), "time", 0, 1e14) * 1e-3;
      if (!ok()) return;
      if (s.time_s < last_s)
        return fail(fmt::format("time {:.9g} s runs back from {:.9g} s", s.time_s, last_s));
      last_s = s.time_s;
      stroke.has_pressure |= s.pressure != kNoSensor;
      stroke.samples.push_back(s);
    }
    sketch_.report.kept = {"places", "times"};
    if (stroke.has_pressure)
      sketch_.report.kept.push_back("pressure");
    else
      sketch_.report.dropped.push_back("pressure, always 0.5: the pen felt none");
    sketch_.report.guessed = {"colour, brush and size, of which the rows have none"};
    if (!stroke.samples.empty()) sketch_.items.push_back(std::move(stroke));
  }

  void read_scene(dom::element root) {
    sketch_.report.kept = {"places", "rotation", "pressure", "colour", "opacity", "width"};
    sketch_.report.guessed = {"times, of which the points have none"};
    dom::array items;
    if (root["libraryItems"].get_array().get(items) == simdjson::SUCCESS ||
        root["library"].get_array().get(items) == simdjson::SUCCESS) {
      read_library(items);
    } else {
      place_ = "root";
      dom::array elements;
      if (root["elements"].get_array().get(elements) != simdjson::SUCCESS)
        return fail("no array 'elements' or 'libraryItems'");
      read_elements(elements, "");
    }
    std::string_view paper;
    if (root["appState"]["viewBackgroundColor"].get(paper) == simdjson::SUCCESS) {
      const auto color = css_color(paper);
      if (color && color->opacity == 1) sketch_.paper = color->linear;
    }
    report_dropped();
  }

  /// An item is an object with elements; in version 1 it is the array itself.
  void read_library(dom::array items) {
    std::vector<std::size_t> begins;
    for (const dom::element item : items) {
      place_ = fmt::format("library item {}", begins.size() + 1);
      dom::array elements;
      if (item.get_array().get(elements) != simdjson::SUCCESS &&
          item["elements"].get_array().get(elements) != simdjson::SUCCESS)
        return fail("no array 'elements'");
      begins.push_back(sketch_.items.size());
      read_elements(elements, place_ + ", ");
      if (!ok()) return;
    }
    begins.push_back(sketch_.items.size());
    lay_out(begins);
  }

  /// Item by item from the left, in rows about as wide as all of them are high.
  void lay_out(const std::vector<std::size_t>& begins) {
    std::vector<Box> boxes(begins.size() - 1);
    double area = 0, widest = 0;
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
      if (begins[i] == begins[i + 1]) continue;
      Box& box = boxes[i];
      for (std::size_t k = begins[i]; k < begins[i + 1]; ++k)
        for (const Sample& s : std::get<Stroke>(sketch_.items[k]).samples) box.add(s.x, s.y);
      area += (box.width() + kGap_px) * (box.height() + kGap_px);
      widest = std::max(widest, box.width());
    }
    const double row_px = std::max(widest, 1.2 * std::sqrt(area));  // 1.2: rows are never full
    double x = 0, y = 0, row_height = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (begins[i] == begins[i + 1]) continue;
      if (x > 0 && x + boxes[i].width() > row_px) {
        y += row_height + kGap_px;
        x = row_height = 0;
      }
      for (std::size_t k = begins[i]; k < begins[i + 1]; ++k) {
        for (Sample& s : std::get<Stroke>(sketch_.items[k]).samples) {
          s.x += x - boxes[i].left;
          s.y += y - boxes[i].top;
        }
      }
      x += boxes[i].width() + kGap_px;
      row_height = std::max(row_height, boxes[i].height());
    }
    sketch_.report.guessed.push_back("places of the library's items, laid out in rows");
  }

  void read_elements(dom::array elements, std::string_view within) {
    std::size_t element_number = 0;
    for (const dom::element element : elements) {
      place_ = fmt::format("{}element {}", within, ++element_number);
      std::string_view type;
      if (element["type"].get(type) != simdjson::SUCCESS) return fail("no type");
      bool deleted = false;
      if (element["isDeleted"].get(deleted) == simdjson::SUCCESS && deleted)
        ++deleted_;
      else if (type != "freedraw")
        ++others_;
      else
        read_stroke(element);
      if (!ok()) return;
    }
  }

  void read_stroke(dom::element element) {
    Stroke stroke;
    read_points(element, stroke);
    read_pressures(element, stroke);
    if (!ok() || stroke.samples.empty()) return;
    rotate(stroke.samples, member(element, "angle", 0, 1e6));
    stroke.width = kDrawnPerStrokeWidth * std::abs(member(element, "strokeWidth", 1, 1e6));
    stroke.opacity = std::clamp(member(element, "opacity", 100, 1e6) / 100, 0.0, 1.0);
    std::string_view name;
    if (element["strokeColor"].get(name) == simdjson::SUCCESS) {
      if (const auto color = css_color(name)) {
        stroke.color = color->linear;
        stroke.opacity *= color->opacity;
      } else {
        ++unknown_colors_;
      }
    }
    if (stroke.opacity == 0)
      ++unseen_;
    else if (ok())
      sketch_.items.push_back(std::move(stroke));
  }

  void read_points(dom::element element, Stroke& stroke) {
    const double x0 = member(element, "x", 0, kMost), y0 = member(element, "y", 0, kMost);
    dom::array points;
    if (element["points"].get_array().get(points) != simdjson::SUCCESS)
      return fail("no array 'points'");
    for (const dom::element point : points) {
      dom::array xy;
      // Old files have a third value, the pressure again.
      if (point.get_array().get(xy) != simdjson::SUCCESS || xy.size() < 2)
        return fail(fmt::format("point {} is not [x, y]", stroke.samples.size() + 1));
      const double x = number(xy.at(0).value_unsafe(), "x of a point", -kMost, kMost);
      const double y = number(xy.at(1).value_unsafe(), "y of a point", -kMost, kMost);
      if (!ok()) return;
      stroke.samples.push_back({.x = x0 + x, .y = y0 + y});
    }
  }

  /// One for each point, unless the device has none and the pressure is made up from the speed.
  void read_pressures(dom::element element, Stroke& stroke) {
    bool simulated = false;
    if (element["simulatePressure"].get(simulated) == simdjson::SUCCESS && simulated) return;
    dom::array pressures;
    if (element["pressures"].get_array().get(pressures) != simdjson::SUCCESS) return;
    std::vector<float> values;
    for (const dom::element p : pressures) {
      values.push_back(static_cast<float>(number(p, "pressure", 0, 1)));
      if (!ok()) return;
    }
    if (values.empty()) return;
    if (values.size() != stroke.samples.size())
      return fail(fmt::format("{} pressures for {} points", values.size(), stroke.samples.size()));
    stroke.has_pressure = true;
    for (std::size_t i = 0; i < values.size(); ++i) stroke.samples[i].pressure = values[i];
  }

  void report_dropped() {
    const auto drop = [&](int count, std::string_view what) {
      if (count > 0) sketch_.report.dropped.push_back(fmt::format("{} {}", count, what));
    };
    drop(others_, "elements that are no free-hand strokes");
    drop(deleted_, "deleted elements");
    drop(unseen_, "transparent strokes");
    drop(unknown_colors_, "unknown colours, painted black");
  }

  const Source& source_;
  Sketch sketch_;
  std::string place_, problem_;
  int others_ = 0, deleted_ = 0, unseen_ = 0, unknown_colors_ = 0;
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlank);
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

/// Whether the text begins with `[[x, y, pressure, milliseconds]`.
bool begins_with_row(std::string_view text) {
  text = without_blanks(text.substr(1));
  if (!text.starts_with('[')) return false;
  constexpr std::size_t kLongestRow = 400;
  const std::string_view row = text.substr(1, text.substr(0, kLongestRow).find(']') - 1);
  if (row.size() >= kLongestRow) return false;
  return std::count(row.begin(), row.end(), ',') == 3 &&
         row.find_first_not_of("0123456789+-.eE, \t\r\n") == std::string_view::npos;
}
}  // namespace

bool is_excalidraw(std::string_view bytes) {
  const std::string_view text = without_blanks(without_bom(bytes));
  if (text.starts_with('[')) return begins_with_row(text);
  if (!text.starts_with('{')) return false;
  constexpr std::string_view kKey = "\"type\"";
  for (std::size_t at = text.find(kKey); at != text.npos; at = text.find(kKey, at + 1)) {
    const std::string_view rest = without_blanks(text.substr(at + kKey.size()));
    if (!rest.starts_with(':')) continue;
    const std::string_view value = without_blanks(rest.substr(1));
    if (value.starts_with("\"excalidraw\"") || value.starts_with("\"excalidrawlib\"")) return true;
  }
  return false;
}

Result<Sketch> read_excalidraw(const Source& source, const ReadOptions&) {
  return ExcalidrawReader(source).read();
}

}  // namespace pentimento::sketch
