#include "core/shading/aov.h"

#include <algorithm>

#include "core/shading/shader.h"

namespace pentimento {
namespace {

void add_vector(std::vector<PlaneSource>& planes, const std::string& group, const char* letters,
                TargetKind kind) {
  for (int i = 0; i < 3; ++i) planes.push_back({group + "." + letters[i], kind, 0, i});
}

/// False for an unknown group.
bool add_group(std::vector<PlaneSource>& planes, const std::string& group,
               const ChannelBasis& basis) {
  if (group == "albedo") {
    add_vector(planes, group, "RGB", TargetKind::kAlbedo);
  } else if (group == "normal") {
    add_vector(planes, group, "XYZ", TargetKind::kNormal);
  } else if (group == "height") {
    planes.push_back({"height.Y", TargetKind::kAlbedo, 0, 3});
  } else if (group == "depth") {
    planes.push_back({"depth.Y", TargetKind::kNormal, 0, 3});
  } else if (group == "diffuse") {
    add_vector(planes, group, "RGB", TargetKind::kDiffuse);
  } else if (group == "specular") {
    add_vector(planes, group, "RGB", TargetKind::kSpecular);
  } else if (group == "reflection") {
    add_vector(planes, group, "RGB", TargetKind::kReflection);
  } else if (group == "wet") {
    planes.push_back({"wet.Y", TargetKind::kPicture, 0, 3});
  } else if (group == "pigment") {
    for (int c = 0; c < basis.channels(); ++c) {
      planes.push_back({"pigment." + basis.name[static_cast<std::size_t>(c)], TargetKind::kPigment,
                        c / 4, c % 4});
    }
  } else {
    return false;
  }
  return true;
}

}  // namespace

Result<std::vector<PlaneSource>> picture_planes(const std::vector<std::string>& aovs,
                                                const ChannelBasis& basis) {
  std::vector<PlaneSource> planes = {{"R", TargetKind::kPicture, 0, 0},
                                     {"G", TargetKind::kPicture, 0, 1},
                                     {"B", TargetKind::kPicture, 0, 2}};
  for (auto group = aovs.begin(); group != aovs.end(); ++group) {
    if (std::find(aovs.begin(), group, *group) != group) continue;
    if (!add_group(planes, *group, basis)) {
      return Error{ErrorCode::kUsage, "unknown AOV '" + *group +
                                          "' (known: albedo, normal, height, depth, diffuse, "
                                          "specular, reflection, wet, pigment)"};
    }
  }
  return planes;
}

Result<std::vector<std::string>> aov_channels(const std::vector<std::string>& aovs,
                                              const ChannelBasis& basis) {
  auto planes = picture_planes(aovs, basis);
  if (!planes) return planes.error();
  std::vector<std::string> names;
  for (std::size_t i = 3; i < planes->size(); ++i) names.push_back((*planes)[i].name);
  return names;
}

}  // namespace pentimento
