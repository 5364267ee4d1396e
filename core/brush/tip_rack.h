#pragma once
// Tips that have been drawn are kept here until their brush is used again. Several brushes in
// several threads may share a rack.

#include <memory>
#include <mutex>
#include <vector>

#include "core/brush/tip.h"

namespace pentimento {

class TipRack {
 public:
  /// The tip of a brush, drawn if it is not there yet. Two brushes with the same name count as
  /// having the same texture.
  std::shared_ptr<const Tip> find(const BrushDefinition& brush);

 private:
  struct Entry {
    std::string name;
    TipShape shape;
    BristleSet bristles;
    float grip = 1;
    std::shared_ptr<const Tip> tip;
  };
  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace pentimento
