#pragma once
// Tips that have been drawn are kept here until their brush is used again. Several brushes in
// several threads may share a rack: those of a simulation and its forks, or of all simulations of a
// process.

#include <memory>
#include <mutex>
#include <vector>

#include "core/brush/tip.h"

namespace pentimento {

class TipRack {
 public:
  /// The tip of a brush, drawn if it is not there yet. Another thread that asks meanwhile waits.
  std::shared_ptr<const Tip> find(const BrushDefinition& brush);

 private:
  struct Entry {
    std::string name;
    TipShape shape;
    Field<float> texture;
    BristleSet bristles;
    float grip = 1;
    std::shared_ptr<const Tip> tip;
  };
  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace pentimento
