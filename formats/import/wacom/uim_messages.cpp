#include "formats/import/wacom/uim_messages.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cmath>

#include "core/optics/srgb.h"
#include "formats/import/sketch/text_rows.h"
#include "formats/import/wacom/uim.pb.h"

namespace pentimento::sketch {

namespace {
constexpr int kMostDigits = 9;         // of a precision
constexpr double kMostPlace_px = 1e7;  // farther away is no drawing
constexpr double kMostTime_s = 1e15;
constexpr double kLeastResolution = 1e-9, kMostResolution = 1e9;

Error bad(const std::string& name, const std::string& problem) {
  return {ErrorCode::kBadInput, name + ": " + problem};
}

bool contains(std::string_view text, std::string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         }) != text.end();
}

/// The nearest brush, by the words of its URI.
BrushKind kind_of_uri(std::string_view brush) {
  for (const char* word : {"raster", "crayon", "pencil", "charcoal", "watercolor", "watercolour"})
    if (contains(brush, word)) return BrushKind::kBristle;
  for (const char* word : {"marker", "chisel", "flat"})
    if (contains(brush, word)) return BrushKind::kFlat;
  return BrushKind::kRound;
}

bool erases(std::string_view render_mode) {
  return contains(render_mode, "destinationout") || contains(render_mode, "destination_out");
}

/// How the values of a channel are stored.
struct ChannelScale {
  std::string kind;       // the end of the type: "X", "Timestamp"
  double resolution = 1;  // per metre, second, ..
  double unit = 1;        // of a stored whole number
  double max = 0;         // 0: not told
};
using ChannelScales = std::map<std::string, ChannelScale>;

/// Running sums of differences; nothing if a sum is out of any range.
template <typename Deltas>
Result<std::vector<double>> sums_of(const std::string& name, const Deltas& deltas, double unit) {
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(deltas.size()));
  std::int64_t sum = 0;
  for (const std::int32_t delta : deltas) {
    sum += delta;
    out.push_back(static_cast<double>(sum) * unit);
    if (!(std::abs(out.back()) <= kMostTime_s))
      return bad(name, fmt::format("a value of {} is too large", out.back()));
  }
  return out;
}

/// Whether the channels are those of a pen, finger or mouse: there may be microphones besides.
template <typename Group>
bool is_of_a_pointer(const Group& group) {
  const auto& channels = group.channels();
  return std::any_of(channels.begin(), channels.end(),
                     [](const auto& channel) { return channel.type().ends_with("/X"); });
}

template <typename InputData>
Result<ChannelScales> scales_of(const std::string& name, const InputData& input) {
  ChannelScales out;
  for (const auto& context : input.context().sensor_contexts()) {
    for (const auto& group : context.groups()) {
      if (!is_of_a_pointer(group)) continue;
      for (const auto& channel : group.channels()) {
        ChannelScale scale;
        scale.kind = channel.type().substr(channel.type().rfind('/') + 1);
        scale.resolution = channel.resolution();
        scale.max = static_cast<double>(channel.max());
        if (!(scale.resolution >= kLeastResolution && scale.resolution <= kMostResolution))
          return bad(name, fmt::format("the resolution of {} is {}", quotable(scale.kind),
                                       scale.resolution));
        if (channel.precision() > kMostDigits)
          return bad(name, fmt::format("the precision of {} is {}, over {}", quotable(scale.kind),
                                       channel.precision(), kMostDigits));
        scale.unit = 1 / (scale.resolution * std::pow(10, channel.precision()));
        out[channel.id()] = scale;
      }
    }
  }
  return out;
}

/// Puts one channel's values where they belong.
void add_channel(UimSensor& sensor, const ChannelScale& scale, std::vector<double> values,
                 double begin_s) {
  const auto times = [&](double factor) {
    for (double& v : values) v *= factor;
  };
  if (scale.kind == "Timestamp") {
    for (double& v : values) v += begin_s;
    sensor.time_s = std::move(values);
  } else if (scale.kind == "X" || scale.kind == "Y") {
    times(scale.resolution);  // metres to the px of the device
    (scale.kind == "X" ? sensor.x_px : sensor.y_px) = std::move(values);
  } else if (scale.kind == "Pressure") {
    if (scale.max > 1) times(1 / scale.max);
    for (double& v : values) v = std::clamp(v, 0.0, 1.0);
    sensor.pressure = std::move(values);
  } else if (scale.kind == "Altitude") {
    sensor.altitude_rad = std::move(values);
  } else if (scale.kind == "Azimuth") {
    sensor.azimuth_rad = std::move(values);
  }
}

template <typename InputData>
Result<std::map<std::string, UimSensor>> sensors_of(const std::string& name,
                                                    const InputData& input) {
  const Result<ChannelScales> scales = scales_of(name, input);
  if (!scales) return scales.error();
  std::map<std::string, UimSensor> out;
  for (const auto& data : input.sensor_data()) {
    UimSensor& sensor = out[data.id()];
    for (const auto& channel : data.channels()) {
      const auto scale = scales->find(channel.channel_id());
      if (scale == scales->end()) continue;  // of something else
      Result<std::vector<double>> values = sums_of(name, channel.deltas(), scale->second.unit);
      if (!values) return values.error();
      const double begin_s = static_cast<double>(data.timestamp()) * 1e-3;
      if (!(begin_s <= kMostTime_s))
        return bad(name, fmt::format("the time {} s is too large", begin_s));
      add_channel(sensor, scale->second, std::move(*values), begin_s);
    }
  }
  return out;
}

/// Whether a stroke's spline can be drawn; what is wrong with it otherwise.
std::string problem_of(const UimStroke& stroke) {
  if (stroke.x.size() != stroke.y.size())
    return fmt::format("a spline has {} x and {} y", stroke.x.size(), stroke.y.size());
  for (const auto* values : {&stroke.x, &stroke.y, &stroke.size})
    for (const double v : *values)
      if (!(std::abs(v) <= kMostPlace_px)) return fmt::format("a spline's value is {}", v);
  if (!(stroke.common_size >= 0 && stroke.common_size <= kMostPlace_px))
    return fmt::format("a size is {}", stroke.common_size);
  return "";
}

template <typename Floats>
std::vector<double> doubles_of(const Floats& floats) {
  return {floats.begin(), floats.end()};
}

/// What strokes refer to by numbers from 1; one long name may be meant by many.
struct UimLists {
  explicit UimLists(const uim::InkData& ink) : properties(ink.properties()) {
    for (const std::string& brush : ink.brushes()) brushes.push_back(kind_of_uri(brush));
    for (const std::string& mode : ink.render_modes()) erase.push_back(erases(mode));
  }
  const google::protobuf::RepeatedPtrField<uim::Property>& properties;
  std::vector<BrushKind> brushes;
  std::vector<char> erase;
};

/// Whether the number means an element of a list.
template <typename List>
bool means_one(const List& list, std::uint32_t number) {
  return number >= 1 && number <= static_cast<std::uint32_t>(list.size());
}

Result<void> read_spline(const std::string& name, const uim::Stroke& from, UimStroke& out) {
  if (!from.has_deltas()) {
    out.x = doubles_of(from.floats().x());
    out.y = doubles_of(from.floats().y());
    out.size = doubles_of(from.floats().size());
    return {};
  }
  const auto digits = [&](int place) {
    return (static_cast<std::uint32_t>(from.precisions()) >> (4 * place)) & 15;
  };
  for (const int place : {0, 1})
    if (digits(place) > kMostDigits)
      return bad(name, fmt::format("a precision is {}, over {}", digits(place), kMostDigits));
  const double place_unit = std::pow(10, -static_cast<int>(digits(0)));
  const double size_unit = std::pow(10, -static_cast<int>(digits(1)));
  const auto& deltas = from.deltas();
  Result<std::vector<double>> x = sums_of(name, deltas.x(), place_unit);
  Result<std::vector<double>> y = sums_of(name, deltas.y(), place_unit);
  Result<std::vector<double>> size = sums_of(name, deltas.size(), size_unit);
  for (const auto* values : {&x, &y, &size})
    if (!*values) return values->error();
  out.x = std::move(*x);
  out.y = std::move(*y);
  out.size = std::move(*size);
  return {};
}

void read_property(const uim::Property& property, UimStroke& out) {
  const auto rgba = static_cast<std::uint32_t>(property.color());
  for (std::size_t c = 0; c < 3; ++c) out.color[c] = kSrgb8ToLinear[(rgba >> (24 - 8 * c)) & 255];
  if ((rgba & 255) != 0) out.opacity = (rgba & 255) / 255.0;  // else each point has its own
  out.common_size = static_cast<double>(property.size());
}

Result<UimStroke> stroke_31(const std::string& name, const UimLists& lists,
                            const uim::Stroke& from) {
  UimStroke out;
  if (const Result<void> spline = read_spline(name, from, out); !spline) return spline.error();
  if (from.has_own_property())
    read_property(from.own_property(), out);
  else if (means_one(lists.properties, from.property()))
    read_property(lists.properties.Get(static_cast<int>(from.property() - 1)), out);
  if (!from.own_brush().empty())
    out.brush = kind_of_uri(from.own_brush());
  else if (means_one(lists.brushes, from.brush()))
    out.brush = lists.brushes[from.brush() - 1];
  if (!from.own_render_mode().empty())
    out.erases = erases(from.own_render_mode());
  else if (means_one(lists.erase, from.render_mode()))
    out.erases = lists.erase[from.render_mode() - 1] != 0;
  out.sensor = from.sensor_data_id();
  if (const std::string problem = problem_of(out); !problem.empty()) return bad(name, problem);
  return out;
}

Result<UimStroke> stroke_30(const std::string& name, const uim::Stroke30& from) {
  UimStroke out;
  out.x = doubles_of(from.x());
  out.y = doubles_of(from.y());
  out.size = doubles_of(from.size());
  const uim::PointProperties30& properties = from.style().properties();
  const float encoded[] = {properties.red().value(), properties.green().value(),
                           properties.blue().value()};
  for (std::size_t c = 0; c < 3; ++c)
    out.color[c] =
        srgb_to_linear(encoded[c] >= 0 ? std::min(static_cast<double>(encoded[c]), 1.0) : 0);
  const double alpha = static_cast<double>(properties.alpha().value());
  if (alpha > 0) out.opacity = std::min(alpha, 1.0);
  out.common_size = static_cast<double>(properties.size().value());
  out.brush = kind_of_uri(from.style().brush());
  out.erases = erases(from.style().render_mode());
  out.sensor = from.sensor_data_id();
  if (const std::string problem = problem_of(out); !problem.empty()) return bad(name, problem);
  return out;
}

void add_stroke(UimStroke stroke, UimInk& ink) {
  if (stroke.x.empty())
    ++ink.empty_strokes;
  else
    ink.strokes.push_back(std::move(stroke));
}

Result<UimInk> ink_30(const std::string& name, const uim::InkObject30& object) {
  UimInk out;
  auto sensors = sensors_of(name, object.input_data());
  if (!sensors) return sensors.error();
  out.sensors = std::move(*sensors);
  for (const uim::Stroke30& from : object.ink_data().strokes()) {
    Result<UimStroke> stroke = stroke_30(name, from);
    if (!stroke) return stroke.error();
    add_stroke(std::move(*stroke), out);
  }
  return out;
}

/// Whether the message could be read. The library's own words about damage stay unsaid.
template <typename Message>
bool parse(Message& message, std::string_view bytes) {
  const google::protobuf::LogSilencer silence;
  return message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}
}  // namespace

Result<UimInk> read_uim_31(const std::string& name, std::string_view input, std::string_view ink) {
  uim::InputData input_data;
  uim::InkData ink_data;
  if (!parse(input_data, input)) return bad(name, "the chunk INPT is damaged");
  if (!parse(ink_data, ink)) return bad(name, "the chunk INKD is damaged");
  UimInk out;
  auto sensors = sensors_of(name, input_data);
  if (!sensors) return sensors.error();
  out.sensors = std::move(*sensors);
  const UimLists lists(ink_data);
  for (const uim::Stroke& from : ink_data.strokes()) {
    Result<UimStroke> stroke = stroke_31(name, lists, from);
    if (!stroke) return stroke.error();
    add_stroke(std::move(*stroke), out);
  }
  return out;
}

Result<UimInk> read_uim_30(const std::string& name, std::string_view data) {
  uim::InkObject30 object;
  if (!parse(object, data)) return bad(name, "the chunk DATA is damaged");
  return ink_30(name, object);
}

Result<UimInk> read_uim_json(const std::string& name, std::string_view json) {
  uim::InkObject30 object;
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = true;
  const google::protobuf::LogSilencer silence;
  const auto status = google::protobuf::util::JsonStringToMessage(
      google::protobuf::StringPiece(json.data(), json.size()), &object, options);
  if (!status.ok()) {
    const std::string_view words(status.message().data(), status.message().size());
    return bad(name, "not its JSON: " + quotable(words.substr(0, words.find('\n')), 120));
  }
  return ink_30(name, object);
}

}  // namespace pentimento::sketch
