// Tables of samples: a line each, fields parted by commas, semicolons or tabs, with or without
// names in the first line. The caller's column map says which column is what; columns that it
// leaves open are found by the usual names. Kept: places, and what there is of times, pressure,
// tilt (by its two angles, or by altitude and azimuth), twist, width and colour (as one word, or as
// red, green and blue, of 255 if any is over 1). Dropped: other columns. A stroke ends where its
// name changes, where the pen is up, where the pressure is 0, or, of tables that have none of
// these, where half a second passes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <numbers>
#include <tuple>

#include "core/optics/srgb.h"
#include "formats/import/read/css_color.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/pen_angles.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr double kGap_s = 0.5;
constexpr double kHalfTurn_rad = std::numbers::pi;
constexpr double kMostCode = 255;         // of red, green and blue
constexpr std::size_t kMostNamed = 8;     // columns that a report names
constexpr std::size_t kLongestName = 24;  // ... by so many letters of their names

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) ==
           std::tolower(static_cast<unsigned char>(q));
  });
}

enum CsvField {
  kX,
  kY,
  kTime,
  kPressure,
  kTiltX,
  kTiltY,
  kAltitude,
  kAzimuth,
  kTwist,
  kStroke,
  kPen,
  kWidth,
  kColor,
  kRed,
  kGreen,
  kBlue
};
constexpr std::size_t kFields = 16;

/// What columns are usually called; the first is the column map's own word.
constexpr std::array<std::array<std::string_view, 4>, kFields> kUsualNames = {
    {{"x", "x_px", "x_mm", "posx"},
     {"y", "y_px", "y_mm", "posy"},
     {"time", "t", "t_s", "timestamp"},
     {"pressure", "p", "force", "pres"},
     {"tilt_x", "tiltx", "tilt-x", "xtilt"},
     {"tilt_y", "tilty", "tilt-y", "ytilt"},
     {"altitude_rad", "altitudeangle", "altitude_angle", "altitude-rad"},
     {"azimuth_rad", "azimuthangle", "azimuth_angle", "azimuth-rad"},
     {"twist", "rotation", "twist_deg", "roll"},
     {"stroke", "stroke_id", "strokeid", "id"},
     {"pen", "down", "pendown", "pen_down"},
     {"width", "size", "linewidth", "line_width"},
     {"color", "colour", "rgb", "hex"},
     {"red", "r", "color_r", "colour_r"},
     {"green", "g", "color_g", "colour_g"},
     {"blue", "b", "color_b", "colour_b"}}};

class CsvReader {
 public:
  CsvReader(const Source& source, const CsvColumns& columns)
      : source_(source), columns_(columns), rest_(without_bom(source.bytes)) {}

  Result<Sketch> read() {
    std::string_view first_rest = rest_;
    const std::string_view first = next_line(first_rest);
    separator_ = separator_of(first);
    const std::vector<std::string_view> names = fields_of(first, separator_);
    const bool named = std::any_of(names.begin(), names.end(), [](std::string_view field) {
      return !field.empty() && !number_of(field);
    });
    width_ = names.size();
    if (!find_columns(names, named) || !complete()) return bad();
    if (named) list_unused(names);
    finish_stroke();  // the first one begins
    if (named) {
      rest_ = first_rest;
      line_ = 1;
    }
    while (!rest_.empty()) {
      ++line_;
      const std::string_view text = next_line(rest_);
      if (!text.empty() && !add_row(fields_of(text, separator_))) return bad();
    }
    finish_stroke();
    return finish();
  }

 private:
  Error bad() const {
    return {ErrorCode::kBadInput,
            fmt::format("{}:{}: {}", source_.name, std::max(line_, 1), problem_)};
  }
  bool fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
    return false;
  }

  /// The column that the map names, by name or number; -1: not there.
  bool find_columns(const std::vector<std::string_view>& names, bool named) {
    const std::array<const std::string*, kFields> wanted = {
        &columns_.x,      &columns_.y,      &columns_.time,     &columns_.pressure,
        &columns_.tilt_x, &columns_.tilt_y, &columns_.altitude, &columns_.azimuth,
        &columns_.twist,  &columns_.stroke, &columns_.pen,      &columns_.width,
        &columns_.color,  &columns_.red,    &columns_.green,    &columns_.blue};
    for (std::size_t f = 0; f < kFields; ++f) {
      at_[f] = -1;
      const std::string& name = *wanted[f];
      const auto number = number_of(name);
      if (number) {
        if (!(*number >= 1 && *number <= static_cast<double>(width_)))
          return fail(fmt::format("there is no column {}, only {}", name, width_));
        at_[f] = static_cast<int>(*number) - 1;
        continue;
      }
      if (!named) {
        // Without names the first two columns are places, unless the map says otherwise.
        if (f <= kY && width_ > f) at_[f] = static_cast<int>(f);
        if (f > kY && !name.empty())
          return fail(
              fmt::format("the columns have no names; '{}' must be a number", quotable(name)));
        continue;
      }
      for (std::size_t c = 0; c < names.size() && at_[f] < 0; ++c) {
        const bool usual = std::any_of(
            kUsualNames[f].begin(), kUsualNames[f].end(),
            [&](std::string_view usual_name) { return same_name(names[c], usual_name); });
        const bool open = name.empty() || name == kUsualNames[f].front();
        if (same_name(names[c], name) || (open && usual)) at_[f] = static_cast<int>(c);
      }
      if (at_[f] < 0 && !name.empty())
        return fail(fmt::format("no column is called '{}'", quotable(name)));
    }
    return true;
  }

  /// Colours of three columns need all of them, leaning by altitude and azimuth needs both.
  bool complete() {
    const auto all_or_none = [&](std::initializer_list<CsvField> fields) {
      if (std::all_of(fields.begin(), fields.end(), [&](CsvField f) { return has(f); }))
        return true;
      for (const CsvField f : fields) at_[f] = -1;
      return false;
    };
    const bool colors = all_or_none({kRed, kGreen, kBlue}),
               angles = all_or_none({kAltitude, kAzimuth});
    if (!colors && !(columns_.red + columns_.green + columns_.blue).empty())
      return fail("a colour needs columns of red, green and blue");
    if (!angles && !(columns_.altitude + columns_.azimuth).empty())
      return fail("a pen that leans needs columns of altitude and azimuth");
    return true;
  }

  /// Which columns are of no use here.
  void list_unused(const std::vector<std::string_view>& names) {
    std::size_t unused = 0;
    for (std::size_t c = 0; c < names.size(); ++c) {
      if (std::find(at_.begin(), at_.end(), static_cast<int>(c)) != at_.end()) continue;
      if (++unused <= kMostNamed)
        sketch_.report.dropped.push_back(
            fmt::format("column {}", quotable(names[c], kLongestName)));
    }
    if (unused > kMostNamed)
      sketch_.report.dropped.push_back(fmt::format("{} more columns", unused - kMostNamed));
  }

  bool has(CsvField field) const { return at_[field] >= 0; }
  std::string_view text(const std::vector<std::string_view>& row, CsvField field) const {
    return row[static_cast<std::size_t>(at_[field])];
  }
  /// The number of a field; `otherwise` if the table has no such column.
  double number(const std::vector<std::string_view>& row, CsvField field, double otherwise) {
    if (!has(field)) return otherwise;
    const std::optional<double> value = number_of(text(row, field));
    if (!value) fail(fmt::format("'{}' is not a number", quotable(text(row, field))));
    return value.value_or(otherwise);
  }
  double in_range(const std::vector<std::string_view>& row, CsvField field, double least,
                  double most) {
    const double value = number(row, field, 0);
    if (!(value >= least && value <= most))
      fail(fmt::format("{} {} is outside {}..{}", kUsualNames[field].front(), value, least, most));
    return value;
  }

  bool add_row(const std::vector<std::string_view>& row) {
    if (row.size() != width_)
      return fail(fmt::format("{} columns, the first line has {}", row.size(), width_));
    Sample s;
    s.x = number(row, kX, 0);
    s.y = number(row, kY, 0) * (columns_.y_up ? -1 : 1);
    s.time_s = number(row, kTime, 0) * columns_.second_per_unit;
    s.pressure = static_cast<float>(in_range(row, kPressure, 0, 1));
    s.tilt_x_deg = static_cast<float>(in_range(row, kTiltX, -90, 90));
    s.tilt_y_deg = static_cast<float>(in_range(row, kTiltY, -90, 90));
    if (has(kAltitude) && !has(kTiltX) && !has(kTiltY))
      std::tie(s.tilt_x_deg, s.tilt_y_deg) =
          tilts_deg(in_range(row, kAltitude, 0, kHalfTurn_rad / 2),
                    in_range(row, kAzimuth, -2 * kHalfTurn_rad, 2 * kHalfTurn_rad));
    s.twist_deg = static_cast<float>(in_range(row, kTwist, -360, 360));
    const double width = number(row, kWidth, 0);
    const bool down = number(row, kPen, 1) != 0;
    if (width < 0) fail(fmt::format("width {} is negative", width));
    // Two hands may have painted at once: a stroke may begin before the last one ended.
    const bool next_stroke = has(kStroke) && any_ && text(row, kStroke) != name_;
    if (any_ && !next_stroke && s.time_s < last_s_)
      fail(fmt::format("time {} runs back", number(row, kTime, 0)));
    if (!problem_.empty()) return false;
    const bool gap =
        !has(kStroke) && !has(kPen) && !has(kPressure) && any_ && s.time_s - last_s_ > kGap_s;
    if (gap || next_stroke) finish_stroke();
    any_ = true;
    last_s_ = s.time_s;
    if (has(kStroke)) name_ = text(row, kStroke);
    // Without another column that says it, a pen that does not press is up.
    const bool hovers = has(kPressure) && !has(kPen) && !has(kStroke) && s.pressure == 0;
    if (!down || hovers) return finish_stroke();
    stroke_.width = std::max(stroke_.width, width);
    stroke_.samples.push_back(s);
    // A stroke has the colour of its first sample.
    if (stroke_.samples.size() > 1) return true;
    return has(kColor) ? set_color(text(row, kColor)) : !has(kRed) || set_codes(row);
  }

  bool set_color(std::string_view words) {
    const std::optional<CssColor> color = css_color(words);
    if (!color) return fail(fmt::format("'{}' is not a colour", quotable(words)));
    stroke_.color = color->linear;
    stroke_.opacity = color->opacity;
    return true;
  }

  /// Red, green and blue wait as they are until it is known of what they are.
  bool set_codes(const std::vector<std::string_view>& row) {
    for (const CsvField field : {kRed, kGreen, kBlue}) {
      const double code = in_range(row, field, 0, kMostCode);
      stroke_.color[static_cast<std::size_t>(field - kRed)] = code;
      most_code_ = std::max(most_code_, code);
    }
    return problem_.empty();
  }

  void convert_codes() {
    const double white = most_code_ > 1 ? kMostCode : 1;
    for (Item& item : sketch_.items)
      for (double& band : std::get<Stroke>(item).color) band = srgb_to_linear(band / white);
  }

  bool finish_stroke() {
    if (!stroke_.samples.empty()) sketch_.items.push_back(std::move(stroke_));
    stroke_ = {};
    stroke_.timed = has(kTime);
    stroke_.has_pressure = has(kPressure);
    stroke_.has_tilt = has(kTiltX) || has(kTiltY) || has(kAltitude);
    stroke_.has_twist = has(kTwist);
    return true;
  }

  Sketch finish() {
    constexpr std::array<const char*, kFields> kWords = {
        "places", nullptr,   "times",           "pressure", "tilt",    nullptr,   "tilt",  nullptr,
        "twist",  "strokes", "pen up and down", "widths",   "colours", "colours", nullptr, nullptr};
    for (std::size_t f = 0; f < kFields; ++f)
      if (at_[f] >= 0 && kWords[f] != nullptr) sketch_.report.kept.emplace_back(kWords[f]);
    if (has(kRed) && !has(kColor)) convert_codes();
    if (!has(kStroke) && !has(kPen) && !has(kPressure))
      sketch_.report.guessed.emplace_back("where strokes end");
    if (!has(kTime)) sketch_.report.guessed.emplace_back("times");
    if (columns_.metre_per_unit > 0) sketch_.metre_per_unit = columns_.metre_per_unit;
    return std::move(sketch_);
  }

  const Source& source_;
  const CsvColumns& columns_;
  std::string_view rest_;
  char separator_ = ',';
  std::size_t width_ = 0;
  std::array<int, kFields> at_{};
  int line_ = 0;
  std::string problem_;
  Sketch sketch_;
  Stroke stroke_;
  std::string name_;
  double last_s_ = 0, most_code_ = 0;
  bool any_ = false;
};

}  // namespace

bool is_csv(std::string_view bytes) {
  std::string_view rest = without_bom(bytes);
  const std::string_view first = next_line(rest);
  if (first.empty() || first.size() > 4096 || first.find('\0') != std::string_view::npos)
    return false;
  const char separator = separator_of(first);
  const std::vector<std::string_view> names = fields_of(first, separator);
  if (names.size() < 2) return false;
  std::size_t numbers = 0, places = 0;
  for (const std::string_view name : names) {
    numbers += number_of(name) ? 1 : 0;
    for (const std::size_t place : {std::size_t{kX}, std::size_t{kY}})
      for (const std::string_view usual : kUsualNames[place])
        places += same_name(name, usual) ? 1 : 0;
  }
  if (numbers == names.size()) return true;
  return places == 2 && fields_of(next_line(rest), separator).size() == names.size();
}

Result<Sketch> read_csv(const Source& source, const ReadOptions& options) {
  return CsvReader(source, options.csv).read();
}

}  // namespace pentimento::sketch
