#pragma once
// `pentimento list`: what logs may name, and what can be read.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace pentimento {

struct CatalogueCell {
  std::string text;
  bool is_text = true;  // in JSON; else `text` is JSON as it is
};

/// A table of what there is; every row has a cell per column.
struct Catalogue {
  std::string kind;
  std::vector<std::string> columns;  // the first is `name`
  std::vector<std::vector<CatalogueCell>> rows;
};

/// The names of the catalogues: brushes, pigments, parameters, formats, limits.
std::vector<std::string_view> catalogue_names();

/// A catalogue; of it only what has the words of `name` in its name, whatever the case, if that is
/// not empty. Errors: kUsage (no such catalogue, nothing of that name; with what is near).
Result<Catalogue> catalogue(std::string_view kind, std::string_view name);

/// One object: {"pigments":[{"name":...},...]}.
std::string catalogue_json(const Catalogue& catalogue);
/// A table with a head.
std::string catalogue_text(const Catalogue& catalogue);

}  // namespace pentimento
