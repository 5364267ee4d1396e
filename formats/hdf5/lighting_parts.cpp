#include "formats/hdf5/lighting_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/optics/tone.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/write_small.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::hdf5 {

namespace {
/// Values of a row of /lighting/more_lamps.
constexpr std::uint64_t kLampValues = 9;
// Beyond these a picture is not finite in single precision.
constexpr float kFarthest = 1e6f;

std::vector<float> row_of(const Lamp& lamp) {
  const auto [x, y, z] = lamp.position_m.value_or(lamp.direction);
  return {x,
          y,
          z,
          lamp.position_m ? 1.0f : 0.0f,
          lamp.color[0],
          lamp.color[1],
          lamp.color[2],
          lamp.intensity,
          lamp.follows_gravity ? 1.0f : 0.0f};
}

Lamp lamp_of(const double* row) {
  const auto at = [&](int i) { return static_cast<float>(row[i]); };
  Lamp lamp;
  if (row[3] != 0) {
    lamp.position_m = {at(0), at(1), at(2)};
  } else {
    lamp.direction = {at(0), at(1), at(2)};
  }
  lamp.color = {at(4), at(5), at(6)};
  lamp.intensity = at(7);
  lamp.follows_gravity = row[8] != 0;
  return lamp;
}

bool read_number(hid_t lighting, const char* name, const log::Range& range, float& member) {
  const std::optional<double> value = number_attribute(lighting, name);
  if (!value) return !has_attribute(lighting, name);
  member = static_cast<float>(*value);
  return *value >= range.min && *value <= range.max;
}

/// A place or a direction: finite, and not the centre.
bool is_somewhere(const std::array<float, 3>& place) {
  float far = 0;
  for (const float v : place) {
    if (!(std::abs(v) <= kFarthest)) return false;
    far = std::max(far, std::abs(v));
  }
  return far > 0;
}

bool may_shine(const Lamp& lamp) {
  const auto fine = [](float light) { return std::abs(light) <= kMostLight; };
  return is_somewhere(lamp.position_m.value_or(lamp.direction)) && fine(lamp.intensity) &&
         std::all_of(lamp.color.begin(), lamp.color.end(), fine);
}
}  // namespace

bool write_lamps(hid_t file, const std::vector<Lamp>& lamps) {
  if (lamps.front().position_m) {
    const auto& place = *lamps.front().position_m;
    if (!write_small(file,
                     {"/lighting/lamp_position",
                      "m",
                      "of the lamp, from the canvas's centre: right, up, out",
                      {3}},
                     std::vector<float>(place.begin(), place.end())))
      return false;
  }
  if (lamps.size() == 1) return true;
  std::vector<float> rows;
  for (auto lamp = lamps.begin() + 1; lamp != lamps.end(); ++lamp) {
    const std::vector<float> row = row_of(*lamp);
    rows.insert(rows.end(), row.begin(), row.end());
  }
  return write_small(file,
                     {"/lighting/more_lamps",
                      "",
                      "right, up, out: a direction, or if the next is 1 a position (m); red, "
                      "green, blue, intensity; 1 if it follows gravity",
                      {lamps.size() - 1, kLampValues}},
                     rows);
}

bool read_lamps(hid_t file, std::vector<Lamp>& lamps) {
  if (!lacks(file, "/lighting/lamp_position")) {
    const auto place = read_doubles(file, "/lighting/lamp_position", {3});
    if (!place) return false;
    lamps.front().position_m = {static_cast<float>((*place)[0]), static_cast<float>((*place)[1]),
                                static_cast<float>((*place)[2])};
  }
  if (lacks(file, "/lighting/more_lamps")) return may_shine(lamps.front());
  const auto shape = dataset_shape(file, "/lighting/more_lamps");
  if (!shape || shape->size() != 2 || (*shape)[0] >= kMostLamps) return false;
  const auto rows = read_doubles(file, "/lighting/more_lamps", {(*shape)[0], kLampValues});
  if (!rows) return false;
  for (std::size_t i = 0; i < rows->size(); i += kLampValues)
    lamps.push_back(lamp_of(rows->data() + i));
  return std::all_of(lamps.begin(), lamps.end(), may_shine);
}

bool read_development(hid_t lighting, Lighting& light) {
  using namespace log;
  if (!read_number(lighting, "varnish", kUnitRange, light.varnish)) return false;
  if (!read_number(lighting, "occlusion", kUnitRange, light.occlusion)) return false;
  if (!read_number(lighting, "white_x", kChromaticityRange, light.white_xy[0])) return false;
  if (!read_number(lighting, "white_y", kChromaticityRange, light.white_xy[1])) return false;
  const std::optional<std::string> name = text_attribute(lighting, "tone_curve");
  if (!name) return !has_attribute(lighting, "tone_curve");
  const std::optional<ToneCurve> curve = tone_curve_of(*name);
  light.tone = curve.value_or(ToneCurve::kNone);
  return curve.has_value();
}

}  // namespace pentimento::hdf5
