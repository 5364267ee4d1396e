// pentimento list brushes|pigments|parameters|formats|limits [NAME]: what logs may name.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "replay/commands/catalogue.h"

namespace pentimento::cli {

namespace {
constexpr const char* kListAbout =
    "List what logs may name, and the recordings that can be converted.\n\n"
    "Examples:\n"
    "  pentimento list brushes\n"
    "  pentimento list pigments ultramarine\n"
    "  pentimento list parameters --json";
}

int run_list(const Arguments& arguments) {
  std::string kind, name;
  bool json = false;
  CLI::App app(kListAbout, "pentimento list");
  app.add_option("what", kind, "what to list")
      ->required()
      ->type_name("brushes|pigments|parameters|formats|limits");
  app.add_option("name", name, "only those with this in their names")->type_name("NAME");
  app.add_flag("--json", json, "one JSON object");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  const Result<Catalogue> found = catalogue(kind, name);
  if (!found) return fail(found.error());
  return print(json ? catalogue_json(*found) + "\n" : catalogue_text(*found));
}

}  // namespace pentimento::cli
