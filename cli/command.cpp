#include "cli/command.h"

#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cerrno>
#include <cstdio>
#include <string_view>

#include "cli/describe.h"
#include "formats/io/stream_write.h"
#include "formats/io/utf8.h"
#include "formats/log/json/nearest_name.h"

namespace pentimento::cli {

namespace {
/// The names of all options of `app`, with their dashes.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

Error unexpected(const CLI::App& app) {
  const std::vector<std::string> rest = app.remaining();
  const std::string word = rest.empty() ? "" : rest.front().substr(0, rest.front().find('='));
  if (word.empty() || word.front() != '-') {
    return {ErrorCode::kUsage, "\"" + word + "\" was not expected"};
  }
  const std::vector<std::string> names = option_names(app);
  const std::vector<std::string_view> views(names.begin(), names.end());
  return {ErrorCode::kUsage, "no option is called " + word + did_you_mean(word, views)};
}
}  // namespace

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return 2;
    case ErrorCode::kBadInput:
      return 3;
    case ErrorCode::kLimit:
      return 4;
    case ErrorCode::kIo:
      return 5;
    case ErrorCode::kNonFinite:
      return 6;
    case ErrorCode::kInterrupted:
      return 75;
  }
  return 3;
}

int fail(const Error& error) {
  std::fprintf(stderr, "pentimento: %s\n", one_line(error.message).c_str());
  return exit_code(error.code);
}

std::optional<int> parse(CLI::App& app, const Arguments& arguments) {
  if (arguments == Arguments{"--describe"}) return print(describe(app) + "\n");
  try {
    app.parse(Arguments(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    return print(app.help());
  } catch (const CLI::ExtrasError&) {
    return fail(unexpected(app));
  } catch (const CLI::Error& error) {
    return fail({ErrorCode::kUsage, error.what()});
  }
  return std::nullopt;
}

int print(const std::string& text) {
  const int error_number = write_to_stream(STDOUT_FILENO, text.data(), text.size());
  if (error_number == 0) return 0;
  if (error_number == EINTR) return fail({ErrorCode::kInterrupted, "interrupted"});
  return fail({ErrorCode::kIo, "standard output cannot be written"});
}

}  // namespace pentimento::cli
