#pragma once
// The picture of a guide and of the finer canvas that follows it. There is one picture, the
// guide's; a finer canvas only says how its light is shared out inside the guide's cells (ADR 19).

#include <vector>

#include "core/base/threads.h"
#include "core/shading/shader.h"

namespace pentimento {

/// A canvas k times finer than its guide, and the guide. Both cover the same canvas.
struct GuidedCanvas {
  const CanvasSource& guide;
  const CanvasSource& fine;
};

/// As Shader::shade(). A picture no larger than the guide shows the guide alone, AOVs included; a
/// larger one shows the fine canvas under a LightLock. Errors: those of Shader::shade().
Result<void> shade_guided(Shader& shader, const GuidedCanvas& canvas, const ChannelBasis& basis,
                          const Model& model, const Lighting& lighting, const ShadeRequest& request,
                          const Threads& threads, const std::vector<PictureSink*>& sinks);

}  // namespace pentimento
