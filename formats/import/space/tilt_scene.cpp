#include "formats/import/space/tilt_scene.h"

#include <fmt/format.h>
#include <simdjson.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/optics/srgb.h"

namespace pentimento::sketch {

namespace {
namespace dom = simdjson::dom;
/// A member that may be missing.
using JsonMember = simdjson::simdjson_result<dom::element>;

/// Of the thumbnail's camera; measured by drawing paintings over their thumbnails.
constexpr double kFieldOfView_rad = 80 * std::numbers::pi / 180;
constexpr double kNear_dm = 0.1;
constexpr double kLeastScale = 1e-6, kMostValue = 1e6;
/// A painting names the brushes that it uses; Open Brush has some 200.
constexpr std::size_t kMostBrushes = 10000;

/// Where something stands: first scaled, then turned, then moved. Left-handed.
struct Placing {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double scale = 1;
};

Error bad(const std::string& name, const std::string& problem) {
  return {ErrorCode::kBadInput, fmt::format("{}: metadata.json: {}", name, problem)};
}

/// Numbers of an array of that length; nothing if it is anything else.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> numbers_of(const JsonMember& from) {
  dom::array values;
  if (from.get_array().get(values) != simdjson::SUCCESS || values.size() != kCount) return {};
  std::array<double, kCount> out{};
  std::size_t i = 0;
  for (const dom::element value : values) {
    if (value.get_double().get(out[i]) != simdjson::SUCCESS || !(std::abs(out[i]) <= kMostValue))
      return {};
    ++i;
  }
  return out;
}

/// [position, quaternion x y z w, scale]; nothing if it is anything else, or has no direction.
std::optional<Placing> placing_of(const JsonMember& from) {
  dom::array parts;
  if (from.get_array().get(parts) != simdjson::SUCCESS || parts.size() != 3) return {};
  const auto move = numbers_of<3>(parts.at(0));
  const auto turn = numbers_of<4>(parts.at(1));
  double scale = 0;
  if (!move || !turn || parts.at(2).get_double().get(scale) != simdjson::SUCCESS) return {};
  Placing out;
  out.move = {(*move)[0], (*move)[1], (*move)[2]};
  out.turn = {(*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2]};
  out.scale = scale;
  const double length = out.turn.norm();
  if (!(length >= kLeastScale) || !(scale >= kLeastScale && scale <= kMostValue)) return {};
  out.turn.normalize();
  return out;
}

/// The room's camera as the scene has it, in right-handed axes.
PinholeCamera camera_of(const Placing& scene, const Placing& camera) {
  const auto mirrored = [](Eigen::Vector3d v) {
    v.z() = -v.z();
    return v;
  };
  const Eigen::Quaterniond to_scene = scene.turn.conjugate();
  const Eigen::Quaterniond axes = to_scene * camera.turn;
  PinholeCamera out;
  out.eye = mirrored(to_scene * (camera.move - scene.move) / scene.scale);
  out.right = mirrored(axes * Eigen::Vector3d::UnitX());
  out.up = mirrored(axes * Eigen::Vector3d::UnitY());
  out.forward = mirrored(axes * Eigen::Vector3d::UnitZ());
  out.half_height = std::tan(kFieldOfView_rad / 2);
  out.near = kNear_dm;
  return out;
}

/// The mean of the colours that the sky goes through.
std::optional<log::Rgb> background_of(dom::element root) {
  dom::array colours;
  if (root["Environment"]["GradientColors"].get_array().get(colours) != simdjson::SUCCESS ||
      colours.size() == 0)
    return {};
  log::Rgb sum = {0, 0, 0};
  for (const dom::element colour : colours) {
    const auto rgba = numbers_of<4>(JsonMember(dom::element(colour)));
    if (!rgba) return {};
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += srgb_to_linear(std::clamp((*rgba)[c] / 255, 0.0, 1.0));
  }
  for (double& c : sum) c /= static_cast<double>(colours.size());
  return sum;
}

std::string text_of(dom::element root, const char* key) {
  std::string_view text;
  return root[key].get_string().get(text) == simdjson::SUCCESS ? std::string(text) : std::string();
}
}  // namespace

Result<TiltScene> read_tilt_scene(const std::string& name, std::string_view json) {
  dom::parser parser;
  dom::element root;
  if (const auto problem = parser.parse(json.data(), json.size()).get(root))
    return bad(name, fmt::format("not valid JSON: {}", simdjson::error_message(problem)));
  dom::array guids;
  if (root["BrushIndex"].get_array().get(guids) != simdjson::SUCCESS)
    return bad(name, "BrushIndex is missing");
  if (guids.size() > kMostBrushes)
    return bad(name, fmt::format("{} brushes are over {}", guids.size(), kMostBrushes));
  TiltScene out;
  for (const dom::element entry : guids) {
    std::string_view guid;
    if (entry.get_string().get(guid) != simdjson::SUCCESS) return bad(name, "a brush is no text");
    const std::optional<TiltBrush> known = tilt_brush(guid);
    out.brushes.push_back(known ? *known : TiltBrush{});
  }
  const std::optional<Placing> scene = placing_of(root["SceneTransformInRoomSpace"]);
  const std::optional<Placing> camera = placing_of(root["ThumbnailCameraTransformInRoomSpace"]);
  if (camera) out.camera = camera_of(scene.value_or(Placing{}), *camera);
  out.background = background_of(root);
  out.title = text_of(root, "Name");
  dom::array authors;
  if (root["Authors"].get_array().get(authors) == simdjson::SUCCESS) {
    for (const dom::element author : authors) {
      std::string_view text;
      if (author.get_string().get(text) != simdjson::SUCCESS) continue;
      out.author += out.author.empty() ? "" : ", ";
      out.author += text;
    }
  }
  return out;
}

}  // namespace pentimento::sketch
