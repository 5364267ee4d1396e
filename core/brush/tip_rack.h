#pragma once
// Tips that have been drawn, kept for when their brush is taken up again. Not thread-safe.

#include <memory>
#include <vector>

#include "core/brush/tip.h"

namespace pentimento {

class TipRack {
 public:
  /// The tip of a brush. A texture is told apart by the brush's name.
  std::shared_ptr<const Tip> find(const BrushDefinition& brush);

 private:
  struct Entry {
    std::string name;
    TipShape shape;
    BristleSet bristles;
    float grip = 1;
    std::shared_ptr<const Tip> tip;
  };
  std::vector<Entry> entries_;
};

}  // namespace pentimento
