#pragma once
// The table of a command's options as JSON, for the programs that make manual pages and
// completions.

#include <string>

namespace CLI {
class App;
}

namespace pentimento::cli {

/// One JSON object: `name`, `about`, and `options`, in the order of the help. Each option has
/// `names` (with their dashes; none for a word that stands without one), `value` (what stands for
/// its value in the help; empty for a flag), `choices` (the words that the value may be; empty if
/// it may be others), `about`, `required` and `repeatable`.
std::string describe(const CLI::App& app);

}  // namespace pentimento::cli
