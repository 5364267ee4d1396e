// pentimento info FILE: what a log, a state dump or a picture holds.

#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "replay/commands/file_info.h"

namespace pentimento::cli {

namespace {
constexpr const char* kInfoAbout =
    "Tell what a log, another program's recording, a state dump or a picture holds; of outputs\n"
    "also where they come from and the command that makes them again.\n\n"
    "Examples:\n"
    "  pentimento info session.jsonl\n"
    "  pentimento info poster.png --json";
}

int run_info(const Arguments& arguments) {
  std::string file;
  bool json = false;
  log::ReaderOptions reading;
  CLI::App app(kInfoAbout, "pentimento info");
  app.add_option("file", file,
                 "log, recording, state dump (.h5), .png or .exr; `-` is a log or a recording on\n"
                 "standard input")
      ->required()
      ->type_name("");
  app.add_flag("--json", json, "one JSON object");
  app.add_flag("--salvage", reading.salvage, "of a log that is cut short in its last line");
  app.add_flag("--allow-outside", reading.allow_outside,
               "the log may name files outside its folder");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  // A picture of characters is for people only.
  constexpr int kPreviewColumns = 64;
  const bool shown = !json && isatty(STDOUT_FILENO) == 1;
  Result<FileInfo> info = file_info(file, reading, shown ? kPreviewColumns : 0);
  if (!info) return fail(info.error());
  return print(json ? info_json(*info) + "\n" : info_text(*info));
}

}  // namespace pentimento::cli
