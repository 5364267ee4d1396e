#pragma once
// What holds for an InkML trace: its channels and its brush. Follows references, never in circles.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "formats/import/read/inkml_trace.h"
#include "formats/import/sketch/sketch.h"

namespace pugi {
class xml_node;
}

namespace pentimento::sketch {

struct InkmlBrush {
  log::Rgb color = {0, 0, 0};
  double opacity = 1;
  double width = 0;               // 0: none given
  bool width_has_length = false;  // the width is in metres
  bool ignores_pressure = false;
  BrushKind kind = BrushKind::kRound;
};

struct InkmlContext {
  std::vector<InkmlChannel> channels = {{"X"}, {"Y"}};
  InkmlBrush brush;
};

/// "trace" of <ink:trace>.
std::string_view local_name(const pugi::xml_node& node);

class InkmlDefinitions {
 public:
  /// Collects all elements that have an id.
  explicit InkmlDefinitions(const pugi::xml_node& root);
  ~InkmlDefinitions();

  /// The element that "#id" names; none if there is none in this file.
  pugi::xml_node find(std::string_view reference) const;

  /// Changes a context by an element's contextRef, traceFormatRef, brushRef and by its children.
  /// False, if that leads to more than 4096 elements: references go in a circle.
  bool apply(const pugi::xml_node& element, InkmlContext& context) const {
    int left = 4096;
    return apply(element, context, 0, left);
  }

 private:
  bool apply(const pugi::xml_node& element, InkmlContext& context, int depth, int& left) const;

  struct NodesById;
  std::unique_ptr<NodesById> nodes_;
};

}  // namespace pentimento::sketch
