#pragma once
// Logs as text for tests: written to a file, read back, with the outcome in one value.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "formats/log/reader.h"

namespace pentimento::log {

inline const std::string kHeaderLine =
    R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":1,"height":0.75}})"
    "\n";

/// A folder of its own, removed with everything in it; in memory where there is such a place, since
/// some tests write thousands of small files.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto parent =
        std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "log-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return file(name);
  }

 private:
  std::filesystem::path path_;
};

struct Outcome {
  bool ok = false;
  ErrorCode code = ErrorCode::kBadInput;
  std::string message;  // of the error
  Header header;
  std::vector<Event> events;
  std::string sha256, salvaged;
};

inline Outcome read_file(const std::string& path, const ReaderOptions& options = {}) {
  Outcome outcome;
  const auto fail = [&](const Error& error) {
    outcome.code = error.code;
    outcome.message = error.message;
    return outcome;
  };
  Result<std::unique_ptr<Reader>> reader = Reader::open(path, options);
  if (!reader) return fail(reader.error());
  outcome.header = (*reader)->header();
  for (;;) {
    Result<std::optional<Event>> event = (*reader)->next();
    if (!event) return fail(event.error());
    if (!*event) break;
    outcome.events.push_back(std::move(**event));
  }
  outcome.ok = true;
  outcome.sha256 = (*reader)->sha256();
  outcome.salvaged = (*reader)->salvaged();
  return outcome;
}

/// The outcome of reading `text` as the file a.jsonl; messages start with "a.jsonl".
inline Outcome read_text(const std::string& text, const ReaderOptions& options = {}) {
  const TemporaryFolder folder;
  Outcome outcome = read_file(folder.write("a.jsonl", text), options);
  const std::string prefix = folder.path().string() + "/";
  if (outcome.message.starts_with(prefix)) outcome.message.erase(0, prefix.size());
  return outcome;
}

}  // namespace pentimento::log
