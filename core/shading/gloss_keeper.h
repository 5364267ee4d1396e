#pragma once
// Keeps the gloss table of a light probe from picture to picture. The frames of a video have the
// same probe, and making the table costs as much as half a picture.

#include "core/optics/gloss_table.h"
#include "core/optics/lighting.h"

namespace pentimento {

class GlossKeeper {
 public:
  /// The table of `lighting`'s probe and roughness; nullptr if it has no probe. Valid until the
  /// next call.
  const GlossTable* table(const Lighting& lighting, const Threads& threads);

 private:
  LightProbe probe_;
  GlossSurface surface_;
  GlossTable table_;
};

}  // namespace pentimento
