#include "formats/hdf5/lighting_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/optics/tone.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/write_small.h"

namespace pentimento::hdf5 {

namespace {
/// Values of a row of /lighting/more_lamps.
constexpr std::uint64_t kLampValues = 9;

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

bool read_share(hid_t lighting, const char* name, float& member) {
  const std::optional<double> value = number_attribute(lighting, name);
  if (!value) return true;
  member = static_cast<float>(*value);
  return *value >= 0 && *value <= 1;
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
  if (has_dataset(file, "/lighting/lamp_position")) {
    const auto place = read_doubles(file, "/lighting/lamp_position", {3});
    if (!place) return false;
    lamps.front().position_m = {static_cast<float>((*place)[0]), static_cast<float>((*place)[1]),
                                static_cast<float>((*place)[2])};
  }
  if (!has_dataset(file, "/lighting/more_lamps")) return true;
  const auto shape = dataset_shape(file, "/lighting/more_lamps");
  if (!shape || shape->size() != 2 || (*shape)[0] >= kMostLamps) return false;
  const auto rows = read_doubles(file, "/lighting/more_lamps", {(*shape)[0], kLampValues});
  if (!rows) return false;
  for (std::size_t i = 0; i < rows->size(); i += kLampValues)
    lamps.push_back(lamp_of(rows->data() + i));
  return true;
}

bool read_development(hid_t lighting, Lighting& light) {
  if (!read_share(lighting, "varnish", light.varnish)) return false;
  if (!read_share(lighting, "occlusion", light.occlusion)) return false;
  if (!read_share(lighting, "white_x", light.white_xy[0])) return false;
  if (!read_share(lighting, "white_y", light.white_xy[1])) return false;
  if (!(light.white_xy[1] > 0)) return false;
  const std::optional<std::string> name = text_attribute(lighting, "tone_curve");
  if (!name) return true;
  const std::optional<ToneCurve> curve = tone_curve_of(*name);
  light.tone = curve.value_or(ToneCurve::kNone);
  return curve.has_value();
}

}  // namespace pentimento::hdf5
