// MyPaint's event recordings: rows of `seconds x y pressure`, pixels, y down; pressure 0 hovers.
// Source: the recordings that libmypaint is tested with. Kept: places, times, pressure. There is no
// colour, brush, size or canvas.

#include <fmt/format.h>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr std::size_t kColumns = 4;

Error bad_row(const Source& source, int line, std::string_view problem) {
  return {ErrorCode::kBadInput, fmt::format("{}:{}: {}", source.name, line, problem)};
}
}  // namespace

bool is_mypaint(std::string_view bytes) {
  std::string_view rest = bytes;
  const std::vector<std::string_view> words = words_of(next_line(rest));
  if (words.size() != kColumns) return false;
  for (const std::string_view word : words)
    if (!number_of(word)) return false;
  return true;
}

Result<Sketch> read_mypaint(const Source& source, const ReadOptions&) {
  Sketch sketch;
  sketch.report.kept = {"places", "times", "pressure"};
  sketch.report.guessed = {"colour, brush and size, of which the recording has none"};
  std::string_view rest = source.bytes;
  Stroke stroke;
  const auto finish = [&] {
    if (!stroke.samples.empty()) sketch.items.push_back(std::move(stroke));
    stroke = {};
    stroke.timed = stroke.has_pressure = true;
  };
  finish();
  double last_s = 0;
  for (int line = 1; !rest.empty(); ++line) {
    const std::vector<std::string_view> words = words_of(next_line(rest));
    if (words.empty()) continue;
    if (words.size() != kColumns)
      return bad_row(source, line, fmt::format("{} columns, a row has 4", words.size()));
    double value[kColumns];
    for (std::size_t i = 0; i < kColumns; ++i) {
      const std::optional<double> number = number_of(words[i]);
      if (!number)
        return bad_row(source, line, fmt::format("'{}' is not a number", quotable(words[i])));
      value[i] = *number;
    }
    const auto [time_s, x, y, pressure] = value;
    if (line > 1 && time_s < last_s)
      return bad_row(source, line, fmt::format("time {} runs back from {}", time_s, last_s));
    last_s = time_s;
    if (pressure < 0 || pressure > 1)
      return bad_row(source, line, fmt::format("pressure {} is outside 0..1", pressure));
    if (pressure == 0)
      finish();
    else
      stroke.samples.push_back(
          {.x = x, .y = y, .time_s = time_s, .pressure = static_cast<float>(pressure)});
  }
  finish();
  return sketch;
}

}  // namespace pentimento::sketch
