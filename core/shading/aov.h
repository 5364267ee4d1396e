#pragma once
// The planes of a shaded picture: their names, and the target where the shader writes each.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/optics/channels.h"

namespace pentimento {

/// The kinds of the shader's targets, with the four values of each.
enum class TargetKind {
  kPicture,     // R G B, wet
  kAlbedo,      // R G B, height
  kNormal,      // X Y Z, depth
  kDiffuse,     // R G B
  kSpecular,    // R G B
  kReflection,  // R G B
  kPigment      // four channels; as many targets as it takes
};

/// One plane: the `component` of the `part`-th target of a kind.
struct PlaneSource {
  std::string name;
  TargetKind kind = TargetKind::kPicture;
  int part = 0;
  int component = 0;
};

/// R, G, B, then the planes of the groups in `aovs`, each group once, in the order asked. Error: an
/// unknown group.
Result<std::vector<PlaneSource>> picture_planes(const std::vector<std::string>& aovs,
                                                const ChannelBasis& basis);

}  // namespace pentimento
