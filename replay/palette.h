#pragma once
// The pigments of a log: those of its header, then one for each colour that was picked, in the
// order of first use. Reaches the state through the channels: no C library functions.

#include <map>
#include <string>
#include <vector>

#include "core/optics/paint_maker.h"
#include "core/result.h"
#include "formats/log/events.h"

namespace pentimento {

class Palette {
 public:
  /// Takes the header's pigments. An empty palette gets `ivory black`, so that a log without
  /// colours paints dark. Errors: kBadInput, an unknown library name.
  static Result<Palette> make(const std::vector<log::PigmentSpec>& header,
                              const PaintMaker& maker = {});

  /// These pigments, whose names differ.
  static Palette of(std::vector<Pigment> pigments, const PaintMaker& maker = {});

  /// A `color` event: a picked colour that is new joins the palette under its "#rrggbb".
  void pick(const log::Color& color);

  /// Index of what the brush is loaded with. `color` went through pick().
  int find(const log::Color& color) const;

  bool has(const std::string& name) const { return index_.contains(name); }
  /// Index of the pigment called `name`, which is there.
  int find(const std::string& name) const { return index_.at(name); }

  const std::vector<Pigment>& pigments() const { return pigments_; }

 private:
  void append(Pigment pigment);

  PaintMaker maker_;
  std::vector<Pigment> pigments_;
  std::map<std::string, int> index_;
};

/// One pigment from what the log says of it. Errors: kBadInput, an unknown library name.
Result<Pigment> make_pigment(const log::PigmentSpec& spec, const PaintMaker& maker = {});

}  // namespace pentimento
