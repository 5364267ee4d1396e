#pragma once
// Runs the real command, for tests.

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/formats/scratch.h"

namespace pentimento::test {

struct Ran {
  int code = -1;  // -1: died of a signal
  std::string out, err;
};

/// A small painting: two colours, two strokes, a tilt, a mark, 1.2 s on 80 x 60 cells.
inline const std::string kSmallLog =
    R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,"height":0.3},)"
    R"("grid":{"width":80,"height":60},"palette":[{"name":"blue","over_white":"#1f2f8c",)"
    R"("over_black":"#05071c"},{"name":"red","K":[0.14,1.08,1.68],"S":[0.77,0.015,0.018]}]})"
    "\n"
    R"({"t":0,"type":"color","pigment":"blue"})"
    "\n"
    R"({"t":0.1,"type":"touch","phase":"down","x":0.1,"y":0.1})"
    "\n"
    R"({"t":0.3,"type":"touch","phase":"move","x":0.25,"y":0.2})"
    "\n"
    R"({"t":0.4,"type":"touch","phase":"up","x":0.3,"y":0.1})"
    "\n"
    R"({"t":0.5,"type":"mark","name":"half"})"
    "\n"
    R"({"t":0.5,"type":"gravity","x":2,"y":3,"z":9})"
    "\n"
    R"({"t":0.6,"type":"color","value":"#e0c020"})"
    "\n"
    R"({"t":0.7,"type":"touch","phase":"down","x":0.2,"y":0.25})"
    "\n"
    R"({"t":0.9,"type":"touch","phase":"up","x":0.3,"y":0.05})"
    "\n"
    R"({"t":1.2,"type":"mark","name":"end"})"
    "\n";

/// A folder with `a.jsonl` (kSmallLog) in which the command runs.
class Workplace {
 public:
  Workplace() { write("a.jsonl", kSmallLog); }

  void write(const std::string& name, const std::string& bytes) {
    spill(scratch_.path(name), bytes);
  }
  std::string read(const std::string& name) const { return slurp(scratch_.path(name)); }
  bool has(const std::string& name) const { return std::filesystem::exists(scratch_.path(name)); }
  std::string path(const std::string& name) const { return scratch_.path(name); }
  std::size_t files() const { return scratch_.files(); }

  /// `pentimento ARGUMENTS` as a shell takes them; `before` stands before the command.
  Ran run(const std::string& arguments, const std::string& before = {}) const {
    const Scratch streams;
    const std::string command = "cd " + scratch_.path("") + " && " + before + " " +
                                PENTIMENTO_COMMAND + " " + arguments + " > " + streams.path("out") +
                                " 2> " + streams.path("err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(streams.path("out")),
            slurp(streams.path("err"))};
  }

 private:
  Scratch scratch_;
};

/// Stands before a command that shall get a signal after some seconds. `timeout` in the foreground
/// sends that signal alone. Otherwise it sends SIGCONT after it, which sets going again what the
/// leak checker of a sanitized program has halted at its end, and that waits for ever.
inline std::string signalled(const std::string& signal, const std::string& after_s) {
  return "timeout --foreground --preserve-status -s " + signal + " " + after_s;
}

/// The text of member `key` of a JSON text, as it stands there; for strings without quotes.
inline std::string json_member(const std::string& json, const std::string& key) {
  const std::size_t at = json.find("\"" + key + "\":");
  if (at == std::string::npos) return {};
  const std::size_t start = at + key.size() + 3;
  if (json[start] == '"') return json.substr(start + 1, json.find('"', start + 1) - start - 1);
  return json.substr(start, json.find_first_of(",}", start) - start);
}

inline std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace pentimento::test
