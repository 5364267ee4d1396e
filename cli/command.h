#pragma once
// What all subcommands share: how they are called, their exit codes, and their error messages.

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

/// The exit code of an error (docs/cli.md).
int exit_code(ErrorCode code);

/// Prints `pentimento: MESSAGE` on standard error, in one line. Returns the exit code.
int fail(const Error& error);

/// Parses `arguments` into the variables bound to `app`. Returns nullopt to go on; else help or a
/// one-line error was printed, and the result is the exit code. Options may stand in any order. The
/// one word `--describe` prints the options as JSON (cli/describe.h).
std::optional<int> parse(CLI::App& app, const Arguments& arguments);

/// Prints on standard output and checks that the text arrived. Returns the exit code.
int print(const std::string& text);

int run_render(const Arguments& arguments);
int run_relight(const Arguments& arguments);
int run_info(const Arguments& arguments);
int run_validate(const Arguments& arguments);
int run_convert(const Arguments& arguments);
int run_list(const Arguments& arguments);
int run_compare(const Arguments& arguments);
int run_verify(const Arguments& arguments);
int run_batch_command(const Arguments& arguments);
int run_batch_report(const Arguments& arguments);

}  // namespace pentimento::cli
