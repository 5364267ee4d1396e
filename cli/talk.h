#pragma once
// Ties a job's Control to the terminal and to signals, and rebuilds the command line for
// provenance.

#include <string>

#include "cli/command.h"
#include "cli/picture_options.h"
#include "cli/progress.h"
#include "replay/job/report.h"

namespace pentimento::cli {

/// `printer` outlives the control.
Control make_control(ProgressPrinter& printer, const TalkOptions& talk);

/// The closing report, where the user wants it. Gives the exit code.
int report(const JobReport& done, const TalkOptions& talk);

/// `pentimento COMMAND ...` as a shell takes it, without the outputs and what changes no output:
/// how the command talks, and what it may take of the machine.
std::string command_line(const std::string& command, const Arguments& arguments);

}  // namespace pentimento::cli
