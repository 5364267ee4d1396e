#pragma once
// The options of `render` for films of a painting's making.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "replay/job/film_choice.h"

namespace CLI {
class App;
}

namespace pentimento::cli {

struct FilmOptions {
  std::string along = "painting";
  std::string length;
  std::optional<int> frames;
  std::optional<double> fps, idle_cut_s;

  void add_to(CLI::App& app);
  /// Errors: kUsage.
  Result<FilmChoice> choice() const;
};

}  // namespace pentimento::cli
