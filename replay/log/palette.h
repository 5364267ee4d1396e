#pragma once
// The pigments of a log: those of its header, then one for each colour that was picked, in the
// order of first use. The palette reaches the state through the channels, so no C library functions
// are used.

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/optics/paints/paint_maker.h"
#include "formats/log/tables/events.h"

namespace pentimento {

class Palette {
 public:
  /// Takes the header's pigments. An empty palette gets `ivory black`, so that a log without
  /// colours paints dark. Errors: kBadInput, an unknown library name.
  static Result<Palette> make(const std::vector<log::PigmentSpec>& header,
                              const PaintMaker& maker = {});

  /// A palette of these pigments. Their names must differ.
  static Palette of(std::vector<Pigment> pigments, const PaintMaker& maker = {});

  /// Takes a `color` event: a picked colour that is new joins the palette under the name "#rrggbb".
  void pick(const log::Color& color);

  /// Index of the pigment of a `color` event, which must have gone through pick().
  int find(const log::Color& color) const;

  bool has(const std::string& name) const { return index_.contains(name); }
  /// Index of the pigment called `name`, which must be in the palette.
  int find(const std::string& name) const { return index_.at(name); }

  const std::vector<Pigment>& pigments() const { return pigments_; }

 private:
  void append(Pigment pigment);

  PaintMaker maker_;
  std::vector<Pigment> pigments_;
  std::map<std::string, int> index_;
};

/// Makes a pigment from a log's description. Errors: kBadInput, an unknown library name.
Result<Pigment> make_pigment(const log::PigmentSpec& spec, const PaintMaker& maker = {});

}  // namespace pentimento
