#include "core/optics/tone.h"
#include "formats/log/parse/header_parser.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/write/json_object.h"
#include "formats/log/write/to_json.h"

namespace pentimento::log {

namespace {

std::string canvas_json(const Header& header) {
  JsonObject canvas;
  canvas.number("width", header.canvas_width_m).number("height", header.canvas_height_m);
  canvas.text("edge", header.edge_open ? "open" : "closed");
  return canvas.close();
}

std::string grid_json(const Header& header) {
  JsonObject grid;
  grid.number("width", header.grid_width).number("height", header.grid_height);
  return grid.close();
}

std::string paper_json(const PaperSpec& paper) {
  JsonObject json;
  json.text("texture", paper.texture).number("relief", paper.relief_m);
  json.number("scale", paper.scale_m).numbers("reflectance", paper.reflectance);
  return json.close();
}

std::string spectrum_json(const PigmentSpec::Coefficients& spectrum) {
  JsonObject json;
  json.numbers("wavelength", spectrum.wavelength_nm);
  json.numbers("K", spectrum.K).numbers("S", spectrum.S);
  return json.close();
}

std::string pigment_json(const PigmentSpec& pigment) {
  JsonObject json;
  json.text("name", pigment.name);
  json.color("over_white", pigment.over_white).color("over_black", pigment.over_black);
  if (pigment.color) json.color("color", pigment.color).number("opacity", pigment.opacity);
  if (pigment.K) json.numbers("K", *pigment.K);
  if (pigment.S) json.numbers("S", *pigment.S);
  if (pigment.spectrum) json.raw("spectrum", spectrum_json(*pigment.spectrum));
  return json.close();
}

std::string bristles_json(const BrushSpec::Bristles& bristles) {
  JsonObject json;
  json.number("count", bristles.count).number("thickness", bristles.thickness);
  json.number("length_spread", bristles.length_spread).number("clumping", bristles.clumping);
  return json.close();
}

void add_curve(JsonObject& json, std::string_view key, const BrushSpec::Curve& curve) {
  std::vector<std::string> points;
  for (const auto& point : curve) points.push_back(json_numbers(point));
  if (!points.empty()) json.raw(key, json_array(points));
}

std::string brush_json(const BrushSpec& brush) {
  JsonObject json;
  json.text("name", brush.name);
  brush.texture.empty() ? json.text("shape", brush.shape) : json.text("texture", brush.texture);
  json.number("spacing", brush.spacing).number("size_pressure", brush.size_pressure);
  json.number("flow_pressure", brush.flow_pressure);
  if (brush.follows_direction) json.flag("follows_direction", *brush.follows_direction);
  json.number("stiffness", brush.stiffness).number("grip", brush.grip);
  json.number("capacity", brush.capacity).number("film", brush.film);
  json.number("absorb", brush.absorb);
  if (brush.bristles) json.raw("bristles", bristles_json(*brush.bristles));
  if (!brush.size.empty() || !brush.flow.empty() || !brush.splay.empty()) {
    JsonObject pressure;
    add_curve(pressure, "size", brush.size);
    add_curve(pressure, "flow", brush.flow);
    add_curve(pressure, "splay", brush.splay);
    json.raw("pressure", pressure.close());
  }
  return json.close();
}

/// Writes all parameters, also those with default values. So a log keeps its meaning if a default
/// ever changes.
std::string model_json(const Model& model) {
  JsonObject json;
  for (const ModelField& field : model_fields()) {
    json.raw(field.name, model_value_json(field, model));
  }
  return json.close();
}

std::string picture_json(const PictureSpec& picture) {
  JsonObject json;
  json.number("exposure", picture.exposure_ev).number("varnish", picture.varnish);
  json.number("occlusion", picture.occlusion);
  json.number("white_temperature", picture.white_temperature_K);
  if (picture.white_xy) json.numbers("white_point", *picture.white_xy);
  if (picture.tone) json.text("tone_curve", tone_curve_name(*picture.tone));
  return json.close();
}

void add_text(JsonObject& json, std::string_view key, const std::string& text) {
  if (!text.empty()) json.text(key, text);
}

}  // namespace

std::string header_json(const Header& header) {
  JsonObject json;
  json.text("type", "header").text("format", "pentimento-log").number("version", kLogVersion);
  json.raw("canvas", canvas_json(header)).raw("grid", grid_json(header));
  json.number("steps_per_second", header.steps_per_second);
  json.raw("paper", paper_json(header.paper));
  std::vector<std::string> palette, brushes;
  for (const PigmentSpec& pigment : header.palette) palette.push_back(pigment_json(pigment));
  for (const BrushSpec& brush : header.brushes) brushes.push_back(brush_json(brush));
  if (!palette.empty()) json.raw("palette", json_array(palette));
  const std::string picture = picture_json(header.picture);
  if (picture != "{}") json.raw("picture", picture);
  if (!brushes.empty()) json.raw("brushes", json_array(brushes));
  json.raw("model", model_json(header.model));
  add_text(json, "title", header.title);
  add_text(json, "author", header.author);
  add_text(json, "recorded_by", header.recorded_by);
  add_text(json, "recorded_at", header.recorded_at);
  json.members(header.extensions);
  return json.close();
}

}  // namespace pentimento::log
