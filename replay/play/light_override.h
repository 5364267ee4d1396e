#pragma once
// Puts the user's light in the place of the log's or the dump's.

#include <optional>

#include "core/base/result.h"
#include "core/optics/lighting.h"
#include "replay/job/render_job.h"

namespace pentimento {

class LightOverride {
 public:
  /// Reads the environment's file, if one is chosen. Errors: those of the file.
  static Result<LightOverride> make(const LightChoice& choice);

  void apply(Lighting& lighting) const;

 private:
  LightChoice choice_;
  Lighting panorama_;  // its harmonics and its probe, if an environment is chosen
};

}  // namespace pentimento
