// SVC files of handwriting research (BDALab, handwriting-sample): a count of rows, then rows of
// `x y time status azimuth altitude pressure`. Whole numbers are the tablet's: lines of 1/5080
// inch, milliseconds, pressure of 32767; others are millimetres, seconds, 0..1. Angles are tenths
// of degrees in both, the azimuth clockwise from the top, as in Wintab. y points up. Status 0
// hovers. Kept: places, times, pressure, tilt. There is no colour, brush or size. The count is not
// trusted: files have one row more than they say.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/pen_angles.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr std::size_t kColumns = 7;
constexpr double kMostPressure = 32767;
constexpr double kRadPerTenth = std::numbers::pi / 1800;

bool is_whole(std::string_view word) {
  return word.find_first_not_of("+-0123456789") == std::string_view::npos;
}

Error bad_row(const Source& source, int line, std::string_view problem) {
  return {ErrorCode::kBadInput, fmt::format("{}:{}: {}", source.name, line, problem)};
}

Result<std::array<double, kColumns>> numbers_of(const Source& source, int line,
                                                const std::vector<std::string_view>& words) {
  std::array<double, kColumns> out{};
  if (words.size() != kColumns)
    return bad_row(source, line, fmt::format("{} columns, a row has 7", words.size()));
  for (std::size_t i = 0; i < kColumns; ++i) {
    const std::optional<double> number = number_of(words[i]);
    if (!number)
      return bad_row(source, line, fmt::format("'{}' is not a number", quotable(words[i])));
    out[i] = *number;
  }
  return out;
}
}  // namespace

bool is_svc(std::string_view bytes) {
  std::string_view rest = bytes;
  const std::vector<std::string_view> count = words_of(next_line(rest));
  if (count.size() != 1 || !is_whole(count[0])) return false;
  const std::vector<std::string_view> row = words_of(next_line(rest));
  return row.size() == kColumns &&
         std::all_of(row.begin(), row.end(), [](std::string_view w) { return number_of(w); });
}

Result<Sketch> read_svc(const Source& source, const ReadOptions&) {
  Sketch sketch;
  sketch.report.kept = {"places", "times", "pressure", "tilt"};
  sketch.report.guessed = {"colour, brush and size, of which the recording has none"};
  std::string_view rest = source.bytes;
  next_line(rest);
  bool raw = true;
  Stroke stroke;
  const auto finish = [&] {
    if (!stroke.samples.empty()) sketch.items.push_back(std::move(stroke));
    stroke = {};
    stroke.timed = stroke.has_pressure = stroke.has_tilt = true;
  };
  finish();
  double last_s = 0;
  bool any = false;
  for (int line = 2; !rest.empty(); ++line) {
    const std::vector<std::string_view> words = words_of(next_line(rest));
    if (words.empty()) continue;
    const Result<std::array<double, kColumns>> row = numbers_of(source, line, words);
    if (!row) return row.error();
    // The first row decides for all: a later one may happen to be whole.
    if (!any) raw = std::all_of(words.begin(), words.end(), is_whole);
    const auto [x, y, time, status, azimuth, altitude, pressure] = *row;
    const double time_s = raw ? time / 1000 : time;
    if (any && time_s < last_s)
      return bad_row(source, line, fmt::format("time {} runs back", time));
    any = true;
    last_s = time_s;
    const double most = raw ? kMostPressure : 1;
    if (!(pressure >= 0 && pressure <= most))
      return bad_row(source, line, fmt::format("pressure {} is outside 0..{}", pressure, most));
    if (status == 0) {
      finish();
      continue;
    }
    Sample s{.x = x, .y = -y, .time_s = time_s, .pressure = static_cast<float>(pressure / most)};
    std::tie(s.tilt_x_deg, s.tilt_y_deg) =
        tilts_deg(altitude * kRadPerTenth, (azimuth - 900) * kRadPerTenth);
    stroke.samples.push_back(s);
  }
  finish();
  return sketch;
}

}  // namespace pentimento::sketch
