// Tables of samples: a line each, fields parted by commas, semicolons or tabs, with or without
// names in the first line. The caller's column map says which column is what; columns that it
// leaves open are found by the usual names. Kept: places, and what there is of times, pressure,
// tilt, twist, width and colour. A stroke ends where its name changes, where the pen is up, where
// the pressure is 0, or, of tables that have none of these, where half a second passes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "formats/import/read/css_color.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr double kGap_s = 0.5;

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) ==
           std::tolower(static_cast<unsigned char>(q));
  });
}

enum CsvField { kX, kY, kTime, kPressure, kTiltX, kTiltY, kTwist, kStroke, kPen, kWidth, kColor };
constexpr std::size_t kFields = 11;

/// What columns are usually called; the first is the column map's own word.
constexpr std::array<std::array<std::string_view, 4>, kFields> kUsualNames = {
    {{"x", "x_px", "x_mm", "posx"},
     {"y", "y_px", "y_mm", "posy"},
     {"time", "t", "t_s", "timestamp"},
     {"pressure", "p", "force", "pres"},
     {"tilt_x", "tiltx", "tilt-x", "xtilt"},
     {"tilt_y", "tilty", "tilt-y", "ytilt"},
     {"twist", "rotation", "twist_deg", "roll"},
     {"stroke", "stroke_id", "strokeid", "id"},
     {"pen", "down", "pendown", "pen_down"},
     {"width", "size", "linewidth", "line_width"},
     {"color", "colour", "rgb", "hex"}}};

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
    if (!find_columns(names, named)) return bad();
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
        &columns_.x,      &columns_.y,      &columns_.time,  &columns_.pressure,
        &columns_.tilt_x, &columns_.tilt_y, &columns_.twist, &columns_.stroke,
        &columns_.pen,    &columns_.width,  &columns_.color};
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
    return !has(kColor) || set_color(text(row, kColor));
  }

  /// A stroke has the colour of its first sample.
  bool set_color(std::string_view words) {
    if (stroke_.samples.size() > 1) return true;
    const std::optional<CssColor> color = css_color(words);
    if (!color) return fail(fmt::format("'{}' is not a colour", quotable(words)));
    stroke_.color = color->linear;
    stroke_.opacity = color->opacity;
    return true;
  }

  bool finish_stroke() {
    if (!stroke_.samples.empty()) sketch_.items.push_back(std::move(stroke_));
    stroke_ = {};
    stroke_.timed = has(kTime);
    stroke_.has_pressure = has(kPressure);
    stroke_.has_tilt = has(kTiltX) || has(kTiltY);
    stroke_.has_twist = has(kTwist);
    return true;
  }

  Sketch finish() {
    constexpr std::array<const char*, kFields> kWords = {
        "places", nullptr,   "times",           "pressure", "tilt",   nullptr,
        "twist",  "strokes", "pen up and down", "widths",   "colours"};
    for (std::size_t f = 0; f < kFields; ++f)
      if (at_[f] >= 0 && kWords[f] != nullptr) sketch_.report.kept.emplace_back(kWords[f]);
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
  double last_s_ = 0;
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
