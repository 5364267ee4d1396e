#include "cli/dispatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "formats/log/json/nearest_name.h"
#include "replay/job/build_info.h"

namespace pentimento::cli {

namespace {
std::string overview(std::span<const Command> commands) {
  std::string text =
      "pentimento replays recorded oil-painting sessions and renders them at any size.\n\n"
      "Examples:\n"
      "  pentimento render session.jsonl -o picture.png\n"
      "  pentimento render session.jsonl -o poster.png --print A2 --dpi 300\n"
      "  pentimento relight state.h5 -o evening.png --light=-1,0.2,0.3\n\n"
      "Commands:\n";
  for (const Command& c : commands) text += fmt::format("  {:<12} {}\n", c.name, c.summary);
  return text +
         "\n`pentimento COMMAND --help` tells more; `pentimento --version` names the build.\n";
}

/// The names of the commands and what each is for, as JSON.
std::string described(std::span<const Command> commands) {
  nlohmann::ordered_json table = nlohmann::ordered_json::array();
  for (const Command& c : commands) table.push_back({{"name", c.name}, {"about", c.summary}});
  return table.dump(2) + "\n";
}

int unknown(std::span<const Command> commands, const std::string& name) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.emplace_back(command.name);
  return fail({ErrorCode::kUsage,
               fmt::format("no command is called \"{}\"{}", name, did_you_mean(name, names))});
}
}  // namespace

int dispatch(std::span<const Command> commands, const Arguments& arguments) {
  if (arguments.empty()) {
    return fail({ErrorCode::kUsage, "no command given (`pentimento --help` lists them)"});
  }
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h" || name == "help") return print(overview(commands));
  if (name == "--describe") return print(described(commands));
  if (name == "--version") return print(software() + "\n");
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& c) { return name == c.name; });
  if (command == commands.end()) return unknown(commands, name);
  return command->run(Arguments(arguments.begin() + 1, arguments.end()));
}

}  // namespace pentimento::cli
