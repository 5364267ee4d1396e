// The command `pentimento`: a table of subcommands.

#include <cstdio>

#include "cli/dispatch.h"
#include "cli/guard.h"
#include "core/base/float_environment.h"

int main(int argc, char** argv) {
  using namespace pentimento::cli;
  static constexpr Command kCommands[] = {
      {"render", "replay a log, write pictures and state", run_render},
      {"relight", "shade a state dump again: other light, no simulation", run_relight},
      {"info", "what a log, a state dump or a picture holds", run_info},
      {"validate", "is this log right?", run_validate},
      {"convert", "another program's recording becomes a log", run_convert},
      {"list", "brushes, pigments, parameters, formats", run_list},
      {"compare", "two pictures or two states: what differs, how much, where", run_compare},
      {"verify", "is the replay the one that was recorded? where do they part?", run_verify},
      {"batch", "many logs, each in a process of its own, judged", run_batch_command},
      {"batch-report", "one report of any number of runs", run_batch_report},
  };
  pentimento::set_plain_arithmetic();
  return guarded_on_large_stack(
      [&] { return dispatch(kCommands, Arguments(argv + 1, argv + argc)); });
}
