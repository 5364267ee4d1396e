#include "formats/log/tables/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "formats/log/json/nearest_name.h"

namespace pentimento::log {

namespace {
constexpr LimitRow kRows[] = {
    {"events", &Limits::max_events, "", "--max-events",
     "two hundred hours of a tablet; blank lines are bounded by as many"},
    {"steps", &Limits::max_steps, "", "--max-steps", "six hundred hours of painting"},
    {"line", &Limits::max_line_bytes, "bytes", "--max-line", "a line is held in memory"},
    {"bytes", &Limits::max_bytes, "bytes", "--limit bytes=N",
     "of the log, decompressed; of a pipe it is what the temporary file holds"},
    {"stamps", &Limits::max_stamps, "", "--limit stamps=N",
     "some minutes of the smallest stamps; an hour of painting has two million"},
    {"move", &Limits::max_move_stamps, "stamps", "--limit move=N",
     "between two samples of a touch; they are held in memory"},
    {"touches", &Limits::max_touches, "at once", "--limit touches=N",
     "each has a brush with its paint"},
    {"colors", &Limits::max_colors, "", "--limit colors=N", "each becomes a pigment"},
    {"pigments", &Limits::max_pigments, "", "--limit pigments=N",
     "of the palette; each is made when the log is opened"},
    {"brushes", &Limits::max_brushes, "", "--limit brushes=N", "each may hold a picture in memory"},
};
}  // namespace

std::span<const LimitRow> limit_rows() {
  return kRows;
}

std::string limit_note(std::int64_t Limits::*value) {
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&](const LimitRow& r) { return r.value == value; });
  return fmt::format(", the limit ({})", row->option);
}

std::string set_limit(Limits& limits, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&](const LimitRow& r) { return r.name == name; });
  if (equals == std::string_view::npos || row == std::end(kRows)) {
    std::vector<std::string_view> names;
    for (const LimitRow& r : kRows) names.push_back(r.name);
    return fmt::format("--limit {} is no NAME=N{}; `pentimento list limits` has the names", text,
                       did_you_mean(name, names));
  }
  const std::string_view number = text.substr(equals + 1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size() || value < 1)
    return fmt::format("--limit {}: {} is no whole number above 0", text, number);
  limits.*row->value = value;
  return {};
}

}  // namespace pentimento::log
