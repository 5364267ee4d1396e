// Sources: Apple, CMDeviceMotion.gravity; Android, SensorEvent TYPE_ACCELEROMETER; W3C, Device
// Orientation and Motion. Safari on iOS reports the opposite sign of the W3C's.

#include "formats/import/gravity_file.h"

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/import/sketch/text_rows.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::sketch {

namespace {
constexpr double kStandardGravity_m_s2 = 9.80665;

struct SensorReading {
  double time_s = 0;
  std::array<double, 3> value{};
};

Error bad(const Source& source, int line, const std::string& problem) {
  return {ErrorCode::kBadInput, fmt::format("{}:{}: {}", source.name, line, problem)};
}

/// What a kind of table calls its columns: time, x, y, z.
struct TableKind {
  std::string_view name;
  std::array<std::vector<std::string_view>, 4> columns;
  double factor;  // to m/s^2 in Android's sense
};
const std::array<TableKind, 2>& table_kinds() {
  static const std::array<TableKind, 2> kKinds = {
      TableKind{"coremotion",
                {{{"t_s", "t", "time", "timestamp"},
                  {"grav_x_g", "grav_x", "gravity_x", "gravity.x", "motionGravityX(G)"},
                  {"grav_y_g", "grav_y", "gravity_y", "gravity.y", "motionGravityY(G)"},
                  {"grav_z_g", "grav_z", "gravity_z", "gravity.z", "motionGravityZ(G)"}}},
                -kStandardGravity_m_s2},
      TableKind{"android",
                {{{"t_s", "t", "time", "timestamp", "seconds_elapsed"},
                  {"x", "ax", "acc_x"},
                  {"y", "ay", "acc_y"},
                  {"z", "az", "acc_z"}}},
                1}};
  return kKinds;
}

/// The kind's columns in a table's header; nothing unless all are there.
std::optional<std::array<std::size_t, 4>> find_columns(
    const TableKind& kind, const std::vector<std::string_view>& header) {
  std::array<std::size_t, 4> out{};
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto found = std::find_if(header.begin(), header.end(), [&](std::string_view name) {
      return std::find(kind.columns[c].begin(), kind.columns[c].end(), name) !=
             kind.columns[c].end();
    });
    if (found == header.end()) return {};
    out[c] = static_cast<std::size_t>(found - header.begin());
  }
  return out;
}

/// Seconds per unit of a column of times, from its median step: sensors give 1 to 2000 readings a
/// second.
double second_per_unit(const std::vector<SensorReading>& readings) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < readings.size(); ++i)
    steps.push_back(readings[i].time_s - readings[i - 1].time_s);
  if (steps.empty()) return 1;
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  const double step = steps[steps.size() / 2];
  return step > 1e5 ? 1e-9 : step > 1.5 ? 1e-3 : 1;
}

Result<std::vector<SensorReading>> read_table(const Source& source, std::string_view wanted,
                                              std::string& kind_name) {
  std::string_view rest = without_bom(source.bytes);
  const std::string_view first_line = next_line(rest);
  const char separator = separator_of(first_line);
  const std::vector<std::string_view> header = fields_of(first_line, separator);
  const TableKind* kind = nullptr;
  std::array<std::size_t, 4> columns{};
  for (const TableKind& candidate : table_kinds()) {
    const auto found = find_columns(candidate, header);
    if (!found || (!wanted.empty() && wanted != candidate.name)) continue;
    kind = &candidate;
    columns = *found;
    break;
  }
  if (kind == nullptr)
    return bad(source, 1, "no columns of time and gravity, as t_s,grav_x_g,grav_y_g,grav_z_g");
  kind_name = kind->name;
  std::vector<SensorReading> out;
  for (int line = 2; !rest.empty(); ++line) {
    const std::string_view text = next_line(rest);
    if (text.empty()) continue;
    const std::vector<std::string_view> fields = fields_of(text, separator);
    if (fields.size() != header.size())
      return bad(source, line,
                 fmt::format("{} columns, the first line has {}", fields.size(), header.size()));
    std::array<double, 4> number{};
    for (std::size_t c = 0; c < number.size(); ++c) {
      const std::optional<double> value = number_of(fields[columns[c]]);
      if (!value)
        return bad(source, line, fmt::format("'{}' is not a number", quotable(fields[columns[c]])));
      number[c] = *value;
    }
    out.push_back({number[0],
                   {number[1] * kind->factor, number[2] * kind->factor, number[3] * kind->factor}});
  }
  const double unit_s = second_per_unit(out);
  const double first = out.empty() ? 0 : out.front().time_s;
  for (SensorReading& reading : out) reading.time_s = (reading.time_s - first) * unit_s;
  return out;
}

/// One DeviceMotionEvent.
Result<SensorReading> read_event(const Source& source, int line, simdjson::dom::element event,
                                 double sign) {
  SensorReading out;
  double time_ms = 0;
  if (event["timeStamp"].get(time_ms) != simdjson::SUCCESS &&
      event["t"].get(time_ms) != simdjson::SUCCESS)
    return bad(source, line, "timeStamp is missing");
  out.time_s = time_ms * 1e-3;
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (event["accelerationIncludingGravity"][kAxes[axis]].get(out.value[axis]) !=
        simdjson::SUCCESS)
      return bad(source, line,
                 fmt::format("accelerationIncludingGravity.{} is missing", kAxes[axis]));
    out.value[axis] *= sign;
  }
  return out;
}

Result<std::vector<SensorReading>> read_events(const Source& source, double sign) {
  simdjson::dom::parser parser;
  std::vector<SensorReading> out;
  const auto add = [&](simdjson::dom::element event, int line) -> std::optional<Error> {
    const Result<SensorReading> reading = read_event(source, line, event, sign);
    if (!reading) return reading.error();
    out.push_back(*reading);
    return {};
  };
  simdjson::dom::array list;
  if (parser.parse(source.bytes.data(), source.bytes.size()).get(list) == simdjson::SUCCESS) {
    for (const simdjson::dom::element event : list)
      if (const auto problem = add(event, static_cast<int>(out.size()) + 1)) return *problem;
  } else {
    std::string_view rest = without_bom(source.bytes);
    for (int line = 1; !rest.empty(); ++line) {
      const std::string_view text = next_line(rest);
      if (text.empty()) continue;
      simdjson::dom::element event;
      if (parser.parse(text.data(), text.size()).get(event) != simdjson::SUCCESS)
        return bad(source, line, "not valid JSON");
      if (const auto problem = add(event, line)) return *problem;
    }
  }
  const double first = out.empty() ? 0 : out.front().time_s;
  for (SensorReading& reading : out) reading.time_s -= first;
  return out;
}

/// From the device's axes to those of a screen that is turned by `turn_deg`.
std::array<double, 3> turned(const std::array<double, 3>& v, int turn_deg) {
  switch (turn_deg) {
    case 90:
      return {-v[1], v[0], v[2]};
    case 180:
      return {-v[0], -v[1], v[2]};
    case 270:
      return {v[1], -v[0], v[2]};
    default:
      return v;
  }
}
}  // namespace

Result<GravityRecording> read_gravity(const Source& source, const GravityOptions& options) {
  GravityRecording out;
  const std::size_t first = without_bom(source.bytes).find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && (without_bom(source.bytes)[first] == '{' ||
                                                        without_bom(source.bytes)[first] == '[');
  if (json) out.kind = options.as.empty() ? "devicemotion" : options.as;
  const Result<std::vector<SensorReading>> readings =
      json ? read_events(source, out.kind == "devicemotion-ios" ? -1 : 1)
           : read_table(source, options.as, out.kind);
  if (!readings) return readings.error();
  if (readings->empty()) return bad(source, 1, "no reading");
  double last_s = 0;
  for (const SensorReading& reading : *readings) {
    const int at = static_cast<int>(out.readings.size()) + 1;
    if (!(reading.time_s >= last_s && reading.time_s <= log::kTimeRange.max))
      return bad(source, at, fmt::format("time of reading {} runs back or is too large", at));
    last_s = reading.time_s;
    const std::array<double, 3> value = turned(reading.value, options.turn_deg);
    for (const double v : value)
      if (!(std::abs(v) <= log::kAccelerationRange.max))
        return bad(source, at, fmt::format("gravity {} m/s^2 of reading {} is too large", v, at));
    log::Event event;
    event.time_us = std::llround(reading.time_s * 1e6);
    const auto rounded = [](double v) { return std::round(v * 1e5) / 1e5; };
    event.action = log::Gravity{rounded(value[0]), rounded(value[1]), rounded(value[2])};
    out.readings.push_back(event);
  }
  return out;
}

}  // namespace pentimento::sketch
