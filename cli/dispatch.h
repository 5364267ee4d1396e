#pragma once
// Finds the subcommand of a command line and runs it. Prints help, version, or a suggestion for a
// misspelt name. Returns the exit code.

#include <span>

#include "cli/command.h"

namespace pentimento::cli {

int dispatch(std::span<const Command> commands, const Arguments& arguments);

}  // namespace pentimento::cli
