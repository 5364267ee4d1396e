#include "replay/output/aov_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/shading/shader.h"

namespace pentimento {

namespace {
/// The negative weights of Catmull-Rom sum to at most 1/8 along an axis. So between cells a surface
/// rises above the cells by at most (1.25^2 - 1) / 2 of their range.
constexpr double kBetweenCells = 0.29;

struct CodeRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void add(std::span<const float> row) {
    for (const float v : row) {
      if (!std::isfinite(v)) continue;
      least = std::min(least, static_cast<double>(v));
      most = std::max(most, static_cast<double>(v));
    }
  }
};

NumberScale scale_of(double least, double most, int channels = 1) {
  constexpr double kSteps = 65535;
  const double range = most > least ? most - least : 1;
  return {least, range / kSteps, channels};
}

/// Sums the given planes row by row.
CodeRange range_of(const CanvasSource& canvas, const std::vector<PlaneId>& planes) {
  const auto width = static_cast<std::size_t>(canvas.geometry().width);
  std::vector<float> sum(width), row(width);
  CodeRange range;
  for (int y = 0; y < canvas.geometry().height; ++y) {
    std::fill(sum.begin(), sum.end(), 0.0f);
    for (const PlaneId& plane : planes) {
      canvas.read(plane, 0, y, row);
      for (std::size_t x = 0; x < width; ++x) sum[x] += row[x];
    }
    range.add(sum);
  }
  return range;
}

/// Depth and pigment are never below 0, and 0 is code 0.
NumberScale from_zero(const CanvasSource& canvas, const std::vector<PlaneId>& planes) {
  return scale_of(0, std::max(range_of(canvas, planes).most, 0.0));
}

NumberScale height_scale(const CanvasSource& canvas, bool between_cells) {
  const CodeRange range = range_of(canvas, {{PlaneKind::kBase}, {PlaneKind::kDepth}});
  if (!(range.most >= range.least)) return scale_of(0, 0);
  const double more = between_cells ? kBetweenCells * (range.most - range.least) : 0;
  return scale_of(range.least - more, range.most + more);
}

void set_scale(AovPicture& picture, int channel, const CanvasSource& canvas, bool between_cells) {
  if (picture.name == "normal") {
    picture.scale = scale_of(-1, 1, 3);
  } else if (picture.name == "wet") {
    picture.scale = scale_of(0, 1);
  } else if (picture.name == "depth") {
    picture.scale = from_zero(canvas, {{PlaneKind::kDepth}});
    picture.unit.assign(1, 'm');
  } else if (picture.name == "height") {
    picture.scale = height_scale(canvas, between_cells);
    picture.unit.assign(1, 'm');
  } else if (channel >= 0) {
    std::vector<PlaneId> planes;
    for (int layer = 0; layer < canvas.layers(); ++layer)
      planes.push_back(pigment_plane(layer, channel));
    picture.scale = from_zero(canvas, planes);
  }
}
}  // namespace

Result<std::vector<AovPicture>> aov_pictures(const std::vector<std::string>& aovs,
                                             const CanvasSource& canvas, const ChannelBasis& basis,
                                             bool between_cells) {
  const Result<std::vector<std::string>> planes = aov_channels(aovs, basis);
  if (!planes) return planes.error();
  constexpr std::string_view kPigment = "pigment.";
  std::vector<AovPicture> pictures;
  std::vector<int> channels;  // of each picture; -1: no pigment
  int pigments = 0;
  for (const std::string& plane : *planes) {
    const bool pigment = plane.starts_with(kPigment);
    const std::string name = pigment ? plane : plane.substr(0, plane.find('.'));
    if (pigment || pictures.empty() || pictures.back().name != name) {
      pictures.push_back({name, {}, {}, {}});
      channels.push_back(pigment ? pigments++ : -1);
    }
    pictures.back().planes.push_back(plane);
  }
  for (std::size_t i = 0; i < pictures.size(); ++i)
    set_scale(pictures[i], channels[i], canvas, between_cells);
  return pictures;
}

std::string aov_path(const std::string& picture, const std::string& name) {
  std::string safe = name;
  for (char& c : safe) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       c == '.' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
    if (!plain) c = '_';
  }
  std::filesystem::path path(picture);
  const std::string extension = path.extension().string();
  std::string out = path.replace_extension().string();
  return out.append(".").append(safe).append(extension);
}

Result<void> PlaneSink::write(const PictureStrip& strip) {
  PictureStrip chosen{strip.y0, strip.rows, names_, {}};
  for (const std::string& name : names_) {
    const auto at = std::find(strip.name.begin(), strip.name.end(), name);
    PENTIMENTO_CHECK(at != strip.name.end());
    chosen.plane.push_back(strip.plane[static_cast<std::size_t>(at - strip.name.begin())]);
  }
  return sink_.write(chosen);
}

}  // namespace pentimento
