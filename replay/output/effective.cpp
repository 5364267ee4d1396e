#include "replay/output/effective.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/optics/tone.h"
#include "formats/io/file_sha256.h"
#include "formats/log/tables/model_fields.h"
#include "replay/job/build_info.h"

namespace pentimento {

namespace {
bool is_plain(char c) {
  constexpr std::string_view kPlain = "%+,-./:=@_";
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         kPlain.find(c) != std::string_view::npos;
}

std::string numbers(const std::array<float, 3>& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

void add_model(const Model& model, Provenance& out) {
  for (const log::ModelField& field : log::model_fields()) {
    out.emplace_back("model." + std::string(field.name), log::model_value_json(field, model));
  }
}

void add_lighting(const Lighting& lighting, Provenance& out) {
  for (std::size_t i = 0; i < lighting.lamps.size(); ++i) {
    const Lamp& lamp = lighting.lamps[i];
    const std::string name = i == 0 ? "light." : fmt::format("light{}.", i);
    if (lamp.position_m) {
      out.emplace_back(name + "position_m", numbers(*lamp.position_m));
    } else {
      out.emplace_back(name + "direction", numbers(lamp.direction));
    }
    out.emplace_back(name + "intensity", fmt::format("{}", lamp.intensity));
    out.emplace_back(name + "color", numbers(lamp.color));
  }
  std::string sh;
  for (const auto& coefficient : lighting.environment.L) {
    if (!sh.empty()) sh.push_back(' ');
    sh.append(numbers(coefficient));
  }
  out.emplace_back("environment.sh", sh);
  out.emplace_back("environment.gloss", lighting.probe[0].empty() ? "sh" : "probe");
  out.emplace_back("reflection", lighting.reflection.rgb[0].empty() ? "environment" : "camera");
  out.emplace_back("varnish", fmt::format("{}", lighting.varnish));
  out.emplace_back("occlusion", fmt::format("{}", lighting.occlusion));
  out.emplace_back("white_point", fmt::format("{} {}", lighting.white_xy[0], lighting.white_xy[1]));
  out.emplace_back("tone_curve", std::string(tone_curve_name(lighting.tone)));
  out.emplace_back("exposure_ev", fmt::format("{}", lighting.exposure_ev));
}
}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string quoted(1, '\'');
  for (const char c : text) {
    if (c == '\'') {
      quoted.append("'\\''");
    } else {
      quoted.push_back(c);
    }
  }
  quoted.push_back('\'');
  return quoted;
}

Result<void> add_file_of_option(const std::string& option, const std::string& path,
                                std::map<std::string, std::string>& files) {
  if (path.empty()) return {};
  Result<std::string> hash = file_sha256(path);
  if (!hash) return hash.error();
  files.emplace(option, std::move(*hash));
  return {};
}

Provenance provenance_of(const Origin& origin, const OutputSize& size, const std::string& pattern) {
  Provenance out = {{"software", software()},
                    {"log_sha256", origin.log_sha256},
                    {"state_sha256", origin.state_sha256},
                    {"guide_sha256", origin.guide_sha256},
                    {"step", std::to_string(origin.step)},
                    {"time_s", fmt::format("{}", origin.time_s)},
                    {"steps_per_second", fmt::format("{}", origin.steps_per_second)},
                    {"grid", fmt::format("{} x {}", origin.grid.width, origin.grid.height)},
                    {"detail", std::to_string(origin.detail)},
                    {"canvas_m", fmt::format("{} x {}", origin.grid.width_m, origin.grid.height_m)},
                    {"picture", fmt::format("{} x {}", size.width, size.height)},
                    {"dpi", fmt::format("{}", size.dpi)},
                    {"command", origin.command + " -o " + shell_word(pattern)}};
  if (!origin.other_painting.empty()) out.emplace_back("painting", origin.other_painting);
  add_model(origin.model, out);
  add_lighting(origin.lighting, out);
  for (const auto& [name, sha256] : origin.files) out.emplace_back("file:" + name, sha256);
  return out;
}

}  // namespace pentimento
