#pragma once
// From the command line to a subcommand, with help, version and a suggestion for a misspelt name.

#include <span>

#include "cli/command.h"

namespace pentimento::cli {

int dispatch(std::span<const Command> commands, const Arguments& arguments);

}  // namespace pentimento::cli
