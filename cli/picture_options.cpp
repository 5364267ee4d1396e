#include "cli/picture_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "cli/range.h"
#include "cli/values.h"
#include "core/optics/tone.h"
#include "formats/log/tables/ranges.h"
#include "replay/play/lighting_track.h"

namespace pentimento::cli {

namespace {
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size() && !text.empty();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    if (comma > start) parts.push_back(text.substr(start, comma - start));
    start = comma + 1;
  }
  return parts;
}

Result<std::array<int, 4>> parse_crop(const std::string& text) {
  Result<std::vector<double>> n = parse_numbers("--crop", text, 4);
  if (!n) return n.error();
  std::array<int, 4> crop{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = (*n)[i];
    constexpr double kMaxPixel = 1 << 30;
    if (!(value >= 0 && value <= kMaxPixel) || value != static_cast<int>(value)) {
      return Error{ErrorCode::kUsage, "--crop " + text + ": expected X,Y,W,H in whole pixels"};
    }
    crop[i] = static_cast<int>(value);
  }
  return crop;
}
bool ends_with(const std::string& path, const std::string& extension) {
  if (path.size() < extension.size()) return false;
  std::string end = path.substr(path.size() - extension.size());
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return end == extension;
}
bool is_exr(const std::string& path) {
  return ends_with(path, ".exr");
}
bool is_png(const std::string& path) {
  return ends_with(path, ".png");
}

/// AOVs need an EXR or a PNG among the outputs, floats need an EXR, 16 bits need a PNG.
Result<void> check_layer_options(const PictureChoice& choice) {
  const std::vector<std::string>& outputs = choice.outputs;
  const bool any_png = std::any_of(outputs.begin(), outputs.end(), [](const std::string& output) {
    return output == "-" || is_png(output);
  });
  if (choice.bit_depth == 16 && !outputs.empty() && !any_png)
    return Error{ErrorCode::kUsage, "--bit-depth 16 needs an -o FILE.png"};
  if (outputs.empty() || std::any_of(outputs.begin(), outputs.end(), is_exr)) return {};
  if (choice.full_float) return Error{ErrorCode::kUsage, "--float needs an -o FILE.exr"};
  if (choice.aovs.empty()) return {};
  if (std::find(outputs.begin(), outputs.end(), "-") != outputs.end()) {
    return Error{ErrorCode::kUsage, "--aov has no place beside -o -: give a file's name"};
  }
  if (std::any_of(outputs.begin(), outputs.end(), is_png)) return {};
  return Error{ErrorCode::kUsage, "--aov needs an -o FILE.exr or FILE.png"};
}

/// A debug view is a PNG and nothing else: its colours are no light.
Result<void> choose_debug_view(const std::string& name, PictureChoice& choice) {
  if (name.empty()) return {};
  choice.debug_view = debug_view_named(name);
  if (!choice.debug_view) {
    return Error{ErrorCode::kUsage,
                 "--debug-view " + name + ": expected one of " + std::string(kDebugViewNames)};
  }
  if (!choice.aovs.empty())
    return Error{ErrorCode::kUsage, "--debug-view and --aov: one at a time"};
  if (std::any_of(choice.outputs.begin(), choice.outputs.end(), is_exr)) {
    return Error{ErrorCode::kUsage, "--debug-view needs an -o FILE.png: its colours are no light"};
  }
  return {};
}

/// A lamp: `dir:X,Y,Z` or `pos:X,Y,Z`, then perhaps its intensity, then perhaps its colour.
Result<Lamp> parse_lamp(const std::string& text) {
  const Error bad = {
      ErrorCode::kUsage,
      "--lamp " + text + ": expected dir:X,Y,Z or pos:X,Y,Z[,INTENSITY[,RED,GREEN,BLUE]]"};
  const bool near = text.rfind("pos:", 0) == 0;
  if (!near && text.rfind("dir:", 0) != 0) return bad;
  const auto values = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
  if (values != 3 && values != 4 && values != 7) return bad;
  Result<std::vector<double>> n = parse_numbers("--lamp", text.substr(4), values);
  if (!n) return n.error();
  const std::array<double, 3> place = {(*n)[0], (*n)[1], (*n)[2]};
  const bool dark = values > 3 && std::any_of(n->begin() + 3, n->end(),
                                              [](double v) { return !(v >= 0 && v <= 1e6); });
  if (place == std::array<double, 3>{} || dark) return bad;
  Lamp lamp;
  if (near) lamp.position_m.emplace();
  for (std::size_t i = 0; near && i < 3; ++i) {
    (*lamp.position_m)[i] = static_cast<float>(place[i]);
  }
  if (!near) lamp.direction = unit_direction(place);
  if (values > 3) lamp.intensity = static_cast<float>((*n)[3]);
  for (std::size_t i = 4; i < values; ++i) lamp.color[i - 4] = static_cast<float>((*n)[i]);
  return lamp;
}

/// A white point: a temperature, or CIE x,y.
Result<void> parse_white(const std::string& text, log::PictureSpec& picture) {
  const bool pair = text.find(',') != std::string::npos;
  Result<std::vector<double>> n = parse_numbers("--white-point", text, pair ? 2 : 1);
  if (!n) return n.error();
  const double low = pair ? log::kChromaticityRange.min : log::kTemperatureRange.min;
  const double high = pair ? log::kChromaticityRange.max : log::kTemperatureRange.max;
  for (const double v : *n) {
    if (v >= low && v <= high) continue;
    return Error{ErrorCode::kUsage,
                 "--white-point " + text + ": expected 1667..25000 K, or x,y within 0.01..0.9"};
  }
  if (pair) {
    picture.white_xy = {(*n)[0], (*n)[1]};
  } else {
    picture.white_temperature_K = (*n)[0];
  }
  return {};
}
}  // namespace

void PictureOptions::add_to(CLI::App& app) {
  app.add_option("-o,--output", outputs,
                 "write .png, .exr or .h5; `-` is PNG on standard output; repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE");
  app.add_option("--width", width, "pixels; the height follows")
      ->check(in_range(1, 1 << 20))
      ->type_name("N");
  app.add_option("--height", height, "pixels; the width follows")
      ->check(in_range(1, 1 << 20))
      ->type_name("N");
  app.add_option("--scale", scale, "times the grid")->check(in_range(1e-6, 1e6))->type_name("S");
  app.add_option("--print", print, "on paper: 60x45cm, 24x18in, 600x450mm, A2")->type_name("SIZE");
  app.add_option("--dpi", dpi, "dots per inch, written into the file (300 with --print)")
      ->check(in_range(1.0, 1e5))
      ->type_name("N");
  app.add_option("--crop", crop, "only this part of the picture, in pixels")->type_name("X,Y,W,H");
  app.add_option("--bit-depth", bit_depth, "of PNG")
      ->check(CLI::IsMember({8, 16}).description(""))
      ->type_name("8|16");
  app.add_option("--profile", profile, "colours of the files")
      ->check(CLI::IsMember({"srgb", "display-p3", "adobe-rgb"}).description(""))
      ->type_name("srgb|display-p3|adobe-rgb");
  app.add_option("--dither", dither, "noise in PNGs of 8 bit, which hides the steps of gradients")
      ->check(CLI::IsMember({"on", "off"}).description(""))
      ->type_name("on|off");
  app.add_flag("--float", full_float, "EXR in full instead of half precision");
  app.add_option(
         "--aov", aov,
         "extra layers in EXRs, or beside PNGs as NAME.albedo.png ...: albedo, normal, height, "
         "depth, diffuse, specular, reflection, wet, pigment")
      ->type_name("NAME,...");
  app.add_option("--debug-view", debug_view, "a field with its scale in place of the picture")
      ->type_name("height|velocity|pigment|layers|wetness");
  app.add_option("--light", light, "lamp: where it is seen (x right, y up, z out), or `gravity`")
      ->type_name("X,Y,Z");
  app.add_option("--environment", environment, "panorama that lights the picture (HDR, EXR, ...)")
      ->type_name("FILE");
  app.add_flag("--soft-environment", soft_environment,
               "gloss shows only the nine harmonics of the light probe");
  app.add_option("--lamp", lamps,
                 "in place of all lamps, up to 7: dir:X,Y,Z or pos:X,Y,Z (m from the canvas's "
                 "centre), then intensity (0.75), then red, green, blue; repeatable")
      ->allow_extra_args(false)
      ->type_name("LAMP");
  app.add_option("--varnish", varnish, "a smooth clear coat over everything, 0..1")
      ->check(in_range(0.0, 1.0))
      ->type_name("SHARE");
  app.add_option("--occlusion", occlusion,
                 "how much relief hides of sky and lamps, 0..1; 0 is not searched")
      ->check(in_range(0.0, 1.0))
      ->type_name("SHARE");
  app.add_option("--white-point", white_point, "of the light that becomes white: K, or x,y of CIE")
      ->type_name("WHITE");
  app.add_option("--tone-curve", tone_curve, "of PNG and film")->type_name("none|soft|filmic");
  app.add_option("--exposure", exposure, "of the picture")
      ->check(in_range(-100.0, 100.0))
      ->type_name("STOPS");
  app.add_option("--tile", tile, "side of a shading tile, pixels")
      ->check(in_range(16, 4096))
      ->type_name("N");
  app.add_option("--backend", backend, "of shading")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}).description(""))
      ->type_name("auto|osmesa|egl");
  app.add_option("--threads", threads, "0 = all")->check(in_range(0, 1024))->type_name("N");
  app.add_flag("--no-clobber", no_clobber, "never replace a file");
}

Result<PictureChoice> PictureOptions::picture() const {
  PictureChoice choice;
  choice.outputs = outputs;
  choice.bit_depth = bit_depth;
  choice.full_float = full_float;
  choice.profile = profile_named(profile).value_or(ColorProfile::kSrgb);
  choice.dither = dither == "on";
  choice.aovs = split(aov);
  choice.tile = tile;
  choice.no_clobber = no_clobber;
  if (Result<void> useful = check_layer_options(choice); !useful) return useful.error();
  if (Result<void> view = choose_debug_view(debug_view, choice); !view) return view.error();
  choice.backend = backend == "osmesa" ? GlBackend::kOsmesa
                   : backend == "egl"  ? GlBackend::kEgl
                                       : GlBackend::kAuto;
  if (crop.empty()) return choice;
  Result<std::array<int, 4>> area = parse_crop(crop);
  if (!area) return area.error();
  choice.crop = *area;
  return choice;
}

Result<void> PictureOptions::development(log::PictureSpec& picture) const {
  picture.exposure_ev = exposure;
  picture.varnish = varnish;
  picture.occlusion = occlusion;
  if (!tone_curve.empty()) {
    picture.tone = tone_curve_of(tone_curve);
    if (!picture.tone) {
      return Error{ErrorCode::kUsage,
                   "--tone-curve " + tone_curve + ": expected none, soft or filmic"};
    }
  }
  return white_point.empty() ? Result<void>() : parse_white(white_point, picture);
}

Result<LightChoice> PictureOptions::lighting() const {
  LightChoice choice;
  choice.environment = environment;
  choice.soft_environment = soft_environment;
  if (Result<void> developed = development(choice.picture); !developed) return developed.error();
  for (const std::string& text : lamps) {
    Result<Lamp> lamp = parse_lamp(text);
    if (!lamp) return lamp.error();
    choice.lamps.push_back(*lamp);
  }
  if (choice.lamps.size() > kMostLamps) {
    return Error{ErrorCode::kUsage, "--lamp: at most 7 lamps"};
  }
  choice.follow_gravity = light == "gravity";
  if (light.empty() || choice.follow_gravity) return choice;
  Result<std::array<double, 3>> direction = parse_vector("--light", light);
  if (!direction) return direction.error();
  if (*direction == std::array<double, 3>{}) {
    return Error{ErrorCode::kUsage, "--light " + light + ": has no direction"};
  }
  choice.direction = *direction;
  return choice;
}

SizeRequest PictureOptions::size() const {
  SizeRequest request;
  request.width = width;
  request.height = height;
  request.scale = scale;
  if (!print.empty()) request.print = print;
  request.dpi = dpi;
  return request;
}

void TalkOptions::add_to(CLI::App& app) {
  app.add_flag("--quiet", quiet, "no progress, no words; errors only");
  app.add_option("--progress", progress, "how far it is, on standard error")
      ->type_name("auto|tty|ndjson|none");
  app.add_flag("--json", json, "closing report as JSON on standard output");
}

Result<void> check_outputs(const std::vector<std::string>& outputs, bool json) {
  if (outputs.empty())
    return Error{ErrorCode::kUsage, "nothing to write: give at least one -o FILE"};
  if (!json || std::find(outputs.begin(), outputs.end(), "-") == outputs.end()) return {};
  return Error{ErrorCode::kUsage, "--json and -o - both want standard output"};
}

}  // namespace pentimento::cli
