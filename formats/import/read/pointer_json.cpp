// Pointer events of a browser as arrays of one length, by their names in W3C Pointer Events: x, y
// (CSS pixels), time (ms), buttons, pressure, tiltX, tiltY (degrees), twist. Source: BDALab's
// handwriting-sample writes them. Bit 1 of `buttons` is the pen's tip, bit 32 its eraser. A
// pressure that is 0.5 throughout is that of a device without a sensor. Kept: places, times,
// pressure, tilt, twist, eraser. There is no colour or size.

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/import/read/readers.h"

namespace pentimento::sketch {

namespace {
namespace dom = simdjson::dom;

enum PointerField { kX, kY, kTime, kButtons, kPressure, kTiltX, kTiltY, kTwist };
constexpr std::size_t kFields = 8;
constexpr std::array<const char*, kFields> kNames = {"x",        "y",     "time",  "buttons",
                                                     "pressure", "tiltX", "tiltY", "twist"};
constexpr std::array<std::pair<double, double>, kFields> kRange = {
    {{-1e7, 1e7}, {-1e7, 1e7}, {-1e15, 1e15}, {0, 63}, {0, 1}, {-90, 90}, {-90, 90}, {-360, 360}}};

using PointerColumns = std::array<std::vector<double>, kFields>;

Error bad(const Source& source, const std::string& problem) {
  return {ErrorCode::kBadInput, fmt::format("{}: {}", source.name, problem)};
}

Result<PointerColumns> columns_of(const Source& source) {
  dom::parser parser;
  dom::object object;
  if (const auto problem = parser.parse(source.bytes.data(), source.bytes.size()).get(object))
    return bad(source, fmt::format("not valid JSON: {}", simdjson::error_message(problem)));
  PointerColumns out;
  for (std::size_t f = 0; f < kFields; ++f) {
    dom::array values;
    if (object[kNames[f]].get(values) != simdjson::SUCCESS) {
      if (f <= kTime) return bad(source, fmt::format("{} is missing, or no array", kNames[f]));
      continue;
    }
    for (const dom::element value : values) {
      double number = 0;
      const bool read = value.get(number) == simdjson::SUCCESS;
      if (!read || !(number >= kRange[f].first && number <= kRange[f].second))
        return bad(source, fmt::format("{}[{}] is not a number of {}..{}", kNames[f], out[f].size(),
                                       kRange[f].first, kRange[f].second));
      out[f].push_back(number);
    }
    if (out[f].size() != out[kX].size())
      return bad(source, fmt::format("{} has {} values, x has {}", kNames[f], out[f].size(),
                                     out[kX].size()));
  }
  return out;
}

bool all_half(const std::vector<double>& pressures) {
  return std::all_of(pressures.begin(), pressures.end(),
                     [](double p) { return p == 0.5 || p == 0; });
}

class PointerReader {
 public:
  explicit PointerReader(const PointerColumns& columns)
      : columns_(columns),
        has_pressure_(!columns[kPressure].empty() && !all_half(columns[kPressure])) {}

  Sketch read() {
    begin();
    for (std::size_t i = 0; i < columns_[kX].size(); ++i) add(i);
    begin();
    sketch_.report.kept = {"places", "times"};
    if (has_pressure_) sketch_.report.kept.emplace_back("pressure");
    if (!columns_[kTiltX].empty()) sketch_.report.kept.emplace_back("tilt");
    sketch_.report.guessed = {"colour, brush and size, of which the recording has none"};
    if (repeated_ > 0) sketch_.report.dropped = {fmt::format("{} repeated events", repeated_)};
    return std::move(sketch_);
  }

 private:
  double at(PointerField field, std::size_t i, double otherwise = 0) const {
    return columns_[field].empty() ? otherwise : columns_[field][i];
  }
  bool repeats(std::size_t i) const {
    return i > 0 && std::all_of(columns_.begin(), columns_.end(), [&](const auto& column) {
             return column.empty() || column[i] == column[i - 1];
           });
  }

  void begin() {
    if (!stroke_.samples.empty()) sketch_.items.push_back(std::move(stroke_));
    stroke_ = {};
    stroke_.timed = true;
    stroke_.has_pressure = has_pressure_;
    stroke_.has_tilt = !columns_[kTiltX].empty() || !columns_[kTiltY].empty();
    stroke_.has_twist = !columns_[kTwist].empty();
  }

  void add(std::size_t i) {
    const int buttons = static_cast<int>(at(kButtons, i, 1));
    const bool erases = (buttons & 32) != 0;
    if ((buttons & 33) == 0) return begin();
    if (repeats(i)) {
      ++repeated_;
      return;
    }
    if (erases != stroke_.erases) begin();
    stroke_.erases = erases;
    Sample s{.x = at(kX, i), .y = at(kY, i), .time_s = at(kTime, i) / 1000};
    // Clocks of browsers may be set back.
    if (!stroke_.samples.empty()) s.time_s = std::max(s.time_s, stroke_.samples.back().time_s);
    s.pressure = static_cast<float>(at(kPressure, i));
    s.tilt_x_deg = static_cast<float>(at(kTiltX, i));
    s.tilt_y_deg = static_cast<float>(at(kTiltY, i));
    s.twist_deg = static_cast<float>(at(kTwist, i));
    stroke_.samples.push_back(s);
  }

  const PointerColumns& columns_;
  bool has_pressure_;
  Sketch sketch_;
  Stroke stroke_;
  int repeated_ = 0;
};

}  // namespace

bool is_pointer_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' &&
         bytes.find("\"x\"") != std::string_view::npos &&
         bytes.find("\"y\"") != std::string_view::npos &&
         bytes.find("\"time\"") != std::string_view::npos &&
         (bytes.find("\"tiltX\"") != std::string_view::npos ||
          bytes.find("\"buttons\"") != std::string_view::npos);
}

Result<Sketch> read_pointer_json(const Source& source, const ReadOptions&) {
  const Result<PointerColumns> columns = columns_of(source);
  if (!columns) return columns.error();
  return PointerReader(*columns).read();
}

}  // namespace pentimento::sketch
