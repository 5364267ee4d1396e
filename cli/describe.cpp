#include "cli/describe.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pentimento::cli {

namespace {
using Json = nlohmann::ordered_json;

/// `a|b|c` names the words that a value may be; `X,Y,Z` and `FILE` name no words.
std::vector<std::string> choices(const std::string& value) {
  if (value.find('|') == std::string::npos) return {};
  std::vector<std::string> words = CLI::detail::split(value, '|');
  for (const std::string& word : words) {
    if (word.empty() || word.find_first_of("=:, ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string::npos)
      return {};
  }
  return words;
}

std::vector<std::string> names(const CLI::Option& option) {
  std::vector<std::string> found;
  for (const std::string& name : option.get_snames()) found.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.push_back("--" + name);
  return found;
}

Json option_json(const CLI::Option& option) {
  const bool flag = option.get_items_expected_max() == 0;
  const std::string value = flag ? "" : option.get_type_name();
  return {{"names", names(option)},
          {"word", option.nonpositional() ? "" : option.get_name(true)},
          {"value", value},
          {"choices", choices(value)},
          {"about", option.get_description()},
          {"required", option.get_required()},
          {"repeatable", option.get_items_expected_max() > 1}};
}
}  // namespace

std::string describe(const CLI::App& app) {
  Json options = Json::array();
  for (const CLI::Option* option : app.get_options()) options.push_back(option_json(*option));
  return Json({{"name", app.get_name()}, {"about", app.get_description()}, {"options", options}})
      .dump(2);
}

}  // namespace pentimento::cli
