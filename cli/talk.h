#pragma once
// Connects a job's Control with the terminal and with signals, and rebuilds the command line for
// the provenance.

#include <string>

#include "cli/command.h"
#include "cli/picture_options.h"
#include "cli/progress.h"
#include "replay/job/report.h"

namespace pentimento::cli {

/// `printer` must outlive the control.
Control make_control(ProgressPrinter& printer, const TalkOptions& talk);

/// Prints the closing report where the user wants it. Returns the exit code.
int report(const JobReport& done, const TalkOptions& talk, ProgressPrinter& printer);

/// `pentimento COMMAND ...` as a shell takes it. It leaves out the outputs and the options that
/// change no output: those for messages, and those for memory and threads.
std::string command_line(const std::string& command, const Arguments& arguments);

}  // namespace pentimento::cli
