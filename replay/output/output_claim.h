#pragma once
// A job's claim on the files that it is going to write: made before any work, kept until the files
// have their names.

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/io/file_lock.h"
#include "replay/output/input_guard.h"

namespace pentimento {

class OutputClaim {
 public:
  /// No claim.
  OutputClaim() = default;
  /// Refuses outputs that are inputs, or one file under two names; removes the temporary files that
  /// killed runs left in the folders of the outputs; and tells other runs that these outputs are
  /// taken. `patterns`: as the options name the outputs, which is what other runs see taken; a film
  /// of a thousand pictures has one. `outputs`: all files. Errors: kUsage; kIo, a folder takes no
  /// files.
  static Result<OutputClaim> take(const std::vector<std::string>& patterns,
                                  const std::vector<std::string>& outputs,
                                  const std::vector<InputFile>& inputs);

 private:
  std::vector<std::unique_ptr<FileLock>> locks_;
};

}  // namespace pentimento
