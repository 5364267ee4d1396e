// Source: W3C Ink Markup Language (InkML), sec. 3.1 (trace formats), 4 (contexts), 5 (brushes).

#include "formats/import/read/inkml_context.h"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <unordered_map>

#include "formats/import/read/css_color.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr int kDeepest = 16;  // of references and nested elements
constexpr std::size_t kMostChannels = 64;

struct Unit {
  std::string_view name;
  double factor;
};
constexpr Unit kLengths[] = {{"m", 1},           {"cm", 1e-2},   {"mm", 1e-3},
                             {"himetric", 1e-5}, {"in", 0.0254}, {"pt", 0.0254 / 72},
                             {"pc", 0.0254 / 6}, {"um", 1e-6}};
constexpr Unit kTimes[] = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
constexpr Unit kPerLength[] = {
    {"1/m", 1}, {"1/cm", 1e-2}, {"1/mm", 1e-3}, {"1/in", 0.0254}, {"dpi", 0.0254}};

template <std::size_t N>
double factor_of(const Unit (&units)[N], std::string_view name) {
  const auto* found = std::find_if(std::begin(units), std::end(units),
                                   [&](const Unit& u) { return u.name == name; });
  return found == std::end(units) ? 0 : found->factor;
}

/// To degrees; angles are in degrees unless they say radians.
double degrees_of(std::string_view unit) {
  return unit == "rad" ? 57.29577951308232 : 1;
}

double attribute(const pugi::xml_node& node, const char* name, double otherwise) {
  return number_of(node.attribute(name).value()).value_or(otherwise);
}

InkmlChannel channel_of(const pugi::xml_node& node, bool intermittent) {
  InkmlChannel out;
  out.name = node.attribute("name").value();
  out.intermittent = intermittent;
  out.initial = std::clamp(attribute(node, "default", 0), -1e12, 1e12);
  out.least = attribute(node, "min", 0);
  out.most = attribute(node, "max", out.least);
  const std::string_view unit = node.attribute("units").value();
  if (out.name == "T") {
    const double factor = factor_of(kTimes, unit);
    out.factor = factor > 0 ? factor : 1e-3;
  } else if (out.name.starts_with('O')) {
    out.factor = degrees_of(unit);
  } else if (const double factor = factor_of(kLengths, unit); factor > 0) {
    out.factor = factor;
    out.has_length = true;
  }
  if (std::string_view(node.attribute("orientation").value()) == "-ve") out.factor = -out.factor;
  return out;
}

std::vector<InkmlChannel> channels_of(const pugi::xml_node& format) {
  std::vector<InkmlChannel> out;
  for (const pugi::xml_node& node : format.children()) {
    if (local_name(node) == "channel") out.push_back(channel_of(node, false));
    if (local_name(node) != "intermittentChannels") continue;
    for (const pugi::xml_node& inner : node.children())
      if (local_name(inner) == "channel") out.push_back(channel_of(inner, true));
  }
  if (out.size() > kMostChannels) out.resize(kMostChannels);
  return out;
}

/// Device units become metres by the device's resolution.
void apply_resolution(const pugi::xml_node& property, std::vector<InkmlChannel>& channels) {
  if (std::string_view(property.attribute("name").value()) != "resolution") return;
  const double per_unit = attribute(property, "value", 0);
  const double length = factor_of(kPerLength, property.attribute("units").value());
  if (!(per_unit > 1e-6) || length == 0) return;
  for (InkmlChannel& channel : channels) {
    if (channel.name != property.attribute("channel").value() || channel.has_length) continue;
    channel.factor *= length / per_unit;
    channel.has_length = true;
  }
}

void apply_brush(const pugi::xml_node& node, InkmlBrush& brush) {
  const std::string_view name = node.attribute("name").value();
  const std::string_view value = node.attribute("value").value();
  const double number = number_of(value).value_or(0);
  if (name == "color") {
    if (const auto color = css_color(value)) brush.color = color->linear;
  } else if (name == "width" && number > 0 && number < 1e9) {
    const double factor = factor_of(kLengths, node.attribute("units").value());
    brush.width_has_length = factor > 0;
    brush.width = factor > 0 ? number * factor : number;
  } else if (name == "transparency") {
    brush.opacity = 1 - std::clamp(number / 255, 0.0, 1.0);  // 255 is not seen
  } else if (name == "ignorePressure") {
    brush.ignores_pressure = value == "true" || value == "1";
  } else if (name == "tip" && value == "rectangle") {
    brush.kind = BrushKind::kFlat;
  }
}
}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

struct InkmlDefinitions::NodesById {
  std::unordered_map<std::string, pugi::xml_node> map;
};

InkmlDefinitions::~InkmlDefinitions() = default;

InkmlDefinitions::InkmlDefinitions(const pugi::xml_node& root)
    : nodes_(std::make_unique<NodesById>()) {
  // A walk without recursion: elements may be nested as deeply as the file is long.
  pugi::xml_node node = root;
  while (node) {
    for (const char* key : {"xml:id", "id"})
      if (const pugi::xml_attribute id = node.attribute(key)) nodes_->map.emplace(id.value(), node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

pugi::xml_node InkmlDefinitions::find(std::string_view reference) const {
  if (!reference.starts_with('#')) return {};
  const auto found = nodes_->map.find(std::string(reference.substr(1)));
  return found == nodes_->map.end() ? pugi::xml_node() : found->second;
}

bool InkmlDefinitions::apply(const pugi::xml_node& element, InkmlContext& context, int depth,
                             int& left) const {
  if (depth > kDeepest || --left < 0) return false;
  for (const char* key : {"contextRef", "inkSourceRef", "traceFormatRef", "brushRef"}) {
    const pugi::xml_node target = find(element.attribute(key).value());
    if (target && !apply(target, context, depth + 1, left)) return false;
  }
  const std::string_view name = local_name(element);
  if (name == "traceFormat") {
    std::vector<InkmlChannel> channels = channels_of(element);
    if (!channels.empty()) context.channels = std::move(channels);
    return true;
  }
  if (name == "traceGroup" || name == "trace") return true;
  for (const pugi::xml_node& child : element.children()) {
    if (--left < 0) return false;
    const std::string_view inner = local_name(child);
    if (name == "brush" && inner == "brushProperty") apply_brush(child, context.brush);
    if (name == "channelProperties" && inner == "channelProperty")
      apply_resolution(child, context.channels);
    if (name != "context" && name != "inkSource") continue;
    if ((inner == "inkSource" || inner == "traceFormat" || inner == "brush" ||
         inner == "channelProperties") &&
        !apply(child, context, depth + 1, left))
      return false;
  }
  return true;
}

}  // namespace pentimento::sketch
