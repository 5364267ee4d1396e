#include "replay/hashes/hash_recorder.h"

namespace pentimento {

Result<void> HashRecorder::stepped(const CanvasState& state, std::int64_t line, bool whole_canvas) {
  hashes_.update(state, threads_, whole_canvas);
  writer_.write({state.step, line, hashes_.fields(), hashes_.changed()});
  return {};
}

}  // namespace pentimento
