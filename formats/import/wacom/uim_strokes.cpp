#include "formats/import/wacom/uim_strokes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "formats/import/sketch/pen_angles.h"

namespace pentimento::sketch {

namespace {
/// Points that a spline has before and after those of the samples.
constexpr std::size_t kLeadIn = 3, kMorePoints = 5;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double middle_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*least + *most) / 2;
}

/// Whether the list has a value for each of `count` samples.
bool has_all(const std::vector<double>& values, std::size_t count) {
  return values.size() == count;
}

void add_spline_samples(const UimStroke& from, Stroke& out) {
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    Sample sample;
    sample.x = from.x[i];
    sample.y = from.y[i];
    // Ends are repeated, for the curve to reach them.
    if (out.samples.empty() || out.samples.back().x != sample.x || out.samples.back().y != sample.y)
      out.samples.push_back(sample);
  }
}

/// Times, pressure and angles of the sensor, places of the spline. Returns whether the sensor has
/// enough for that.
bool add_sensor_samples(const UimStroke& from, const UimSensor& sensor, Stroke& out) {
  const std::size_t count = sensor.time_s.size();
  const bool on_spline = from.x.size() == count + kMorePoints;
  const bool has_places = has_all(sensor.x_px, count) && has_all(sensor.y_px, count);
  if (count == 0 || !(on_spline || has_places)) return false;
  const double shift_x = on_spline ? 0 : middle_of(from.x) - middle_of(sensor.x_px);
  const double shift_y = on_spline ? 0 : middle_of(from.y) - middle_of(sensor.y_px);
  out.timed = true;
  out.has_pressure = has_all(sensor.pressure, count);
  out.has_tilt = has_all(sensor.altitude_rad, count) && has_all(sensor.azimuth_rad, count);
  for (std::size_t i = 0; i < count; ++i) {
    Sample sample;
    sample.x = on_spline ? from.x[i + kLeadIn] : sensor.x_px[i] + shift_x;
    sample.y = on_spline ? from.y[i + kLeadIn] : sensor.y_px[i] + shift_y;
    sample.time_s = sensor.time_s[i];
    if (i > 0) sample.time_s = std::max(sample.time_s, out.samples.back().time_s);
    if (out.has_pressure) sample.pressure = static_cast<float>(sensor.pressure[i]);
    if (out.has_tilt)
      std::tie(sample.tilt_x_deg, sample.tilt_y_deg) =
          tilts_deg(sensor.altitude_rad[i], sensor.azimuth_rad[i]);
    out.samples.push_back(sample);
  }
  return true;
}

/// What the report counts.
struct Counted {
  int timed = 0, pressed = 0, tilted = 0, untimed = 0;
};

void report(const Counted& counted, int empty, std::size_t unused_sensors, Report& report) {
  report.kept = {"places of the splines", "colour", "width"};
  if (counted.timed > 0) report.kept.emplace_back("times");
  if (counted.pressed > 0) report.kept.emplace_back("pressure");
  if (counted.tilted > 0) report.kept.emplace_back("tilt from altitude and azimuth");
  report.guessed = {"brushes, from their names"};
  if (counted.untimed > 0)
    report.guessed.push_back(fmt::format("times of {} strokes without a sensor", counted.untimed));
  if (unused_sensors > 0)
    report.dropped.push_back(fmt::format("{} recordings of erased strokes", unused_sensors));
  if (empty > 0) report.dropped.push_back(fmt::format("{} strokes without points", empty));
  report.dropped.insert(report.dropped.end(), {"width and colour within a stroke",
                                               "pictures of brushes", "groups and meanings"});
}
}  // namespace

void add_uim_strokes(const UimInk& ink, Sketch& sketch) {
  Counted counted;
  std::map<std::string, UimSensor> unused = ink.sensors;
  for (const UimStroke& from : ink.strokes) {
    unused.erase(from.sensor);
    Stroke out;
    out.color = from.color;
    out.opacity = from.opacity;
    out.width = std::max(0.0, from.size.empty() ? from.common_size : mean_of(from.size));
    out.brush = from.brush;
    out.erases = from.erases;
    const auto sensor = ink.sensors.find(from.sensor);
    if (sensor == ink.sensors.end() || !add_sensor_samples(from, sensor->second, out))
      add_spline_samples(from, out);
    ++(out.timed ? counted.timed : counted.untimed);
    counted.pressed += out.has_pressure ? 1 : 0;
    counted.tilted += out.has_tilt ? 1 : 0;
    sketch.items.emplace_back(std::move(out));
  }
  report(counted, ink.empty_strokes, unused.size(), sketch.report);
}

}  // namespace pentimento::sketch
