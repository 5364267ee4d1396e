#include "cli/picture_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "cli/range.h"
#include "cli/values.h"

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
  app.add_flag("--float", full_float, "EXR in full instead of half precision");
  app.add_option("--aov", aov,
                 "extra EXR layers: albedo, normal, height, depth, diffuse, specular, reflection, "
                 "wet, pigment")
      ->type_name("NAME,...");
  app.add_option("--light", light, "lamp: where it is seen (x right, y up, z out), or `gravity`")
      ->type_name("X,Y,Z");
  app.add_option("--environment", environment, "panorama that lights the picture (HDR, EXR, ...)")
      ->type_name("FILE");
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
  choice.aovs = split(aov);
  choice.tile = tile;
  choice.no_clobber = no_clobber;
  choice.backend = backend == "osmesa" ? GlBackend::kOsmesa
                   : backend == "egl"  ? GlBackend::kEgl
                                       : GlBackend::kAuto;
  if (crop.empty()) return choice;
  Result<std::array<int, 4>> area = parse_crop(crop);
  if (!area) return area.error();
  choice.crop = *area;
  return choice;
}

Result<LightChoice> PictureOptions::lighting() const {
  LightChoice choice;
  choice.environment = environment;
  choice.exposure_ev = exposure;
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
  app.add_option("--progress", progress, "auto, tty, ndjson or none")->type_name("MODE");
  app.add_flag("--json", json, "closing report as JSON on standard output");
}

Result<void> check_standard_output(const std::vector<std::string>& outputs, bool json) {
  if (!json || std::find(outputs.begin(), outputs.end(), "-") == outputs.end()) return {};
  return Error{ErrorCode::kUsage, "--json and -o - both want standard output"};
}

}  // namespace pentimento::cli
