#pragma once
// The files that a log names. They are found by the rules of docs/action-log.md (in the log's
// folder, no way out of it), and kept with their SHA-256 for the provenance of every output.

#include <map>
#include <string>

#include "core/base/result.h"

namespace pentimento {

class LogFiles {
 public:
  /// `log_path` as the user gave it ("-": the working folder). `allow_outside` lets names leave it.
  LogFiles(std::string log_path, bool allow_outside);

  /// Returns the path to open for `name`, and notes the SHA-256 of the file. Errors: kBadInput (a
  /// way out of the folder), kIo (cannot be read).
  Result<std::string> use(const std::string& name);

  /// The same for a picture. The first time the picture is also decoded, so that a broken one is
  /// found before any work. Errors: also those of the picture.
  Result<std::string> use_picture(const std::string& name);

  /// The same for what the front camera saw: a picture, or a video, whose first frame is decoded.
  Result<std::string> use_camera(const std::string& name);

  /// The name of the log in messages.
  const std::string& log_name() const { return log_path_; }
  /// Name in the log -> path to open, for all used so far.
  const std::map<std::string, std::string>& paths() const { return paths_; }
  /// Name in the log -> SHA-256 (hex) of the file, for all used so far.
  const std::map<std::string, std::string>& hashes() const { return hashes_; }

 private:
  std::string log_path_;
  bool allow_outside_;
  std::map<std::string, std::string> paths_;
  std::map<std::string, std::string> hashes_;
};

}  // namespace pentimento
