#pragma once
// What all subcommands share: how they are called, what they give back, how they say what is wrong.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace pentimento::cli {

/// The words after the command's name.
using Arguments = std::vector<std::string>;

/// A row of main's table.
struct Command {
  const char* name;
  const char* summary;
  int (*run)(const Arguments& arguments);
};

/// docs/cli.md, exit codes.
int exit_code(ErrorCode code);

/// Says `pentimento: MESSAGE` on standard error in one line; gives the exit code.
int fail(const Error& error);

/// Parses `arguments` into what was bound to `app`. Nothing: go on; else the exit code, help or a
/// one-line error having been printed. Options may stand in any order.
std::optional<int> parse(CLI::App& app, const Arguments& arguments);

/// Prints on standard output and checks that it arrived. Gives the exit code.
int print(const std::string& text);

int run_render(const Arguments& arguments);
int run_relight(const Arguments& arguments);
int run_info(const Arguments& arguments);
int run_validate(const Arguments& arguments);
int run_compare(const Arguments& arguments);

}  // namespace pentimento::cli
