#pragma once
// The folder of a batch's run. Several processes may write to it at a time, each job's result
// appears whole, and a run that was cut off goes on from what is there (docs/batch.md).
//
//     manifest.jsonl        what the run is to do
//     results/KEY/          result.json, picture.png and whatever else the job wrote
//     rows/HASH.json        the verdict on an id, and the key of its result
//     golden/SHA256.png     golden pictures that a result differed from

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/job_result.h"
#include "replay/batch/row.h"

namespace pentimento {

class RunFolder {
 public:
  /// Makes the folder if it is not there, and removes what killed processes had begun in it.
  /// Errors: kIo.
  static Result<RunFolder> make(const std::string& path);
  /// Opens one that is there. Errors: kBadInput if it is no run.
  static Result<RunFolder> open(const std::string& path);

  /// The result of a key, if there is one; one that cannot be read is none.
  std::optional<JobResult> find(const std::string& key) const;
  /// A new empty folder in which a job may write. Errors: kIo.
  Result<std::string> begin(const std::string& key) const;
  /// Puts what the job wrote into `work`, and its result, in the place of the key's. If a result
  /// stands there that would end so again, that stays, gets the files that it lacks, and is
  /// returned. Errors: kIo.
  Result<JobResult> keep(const JobResult& result, const std::string& work) const;
  static void discard(const std::string& work);

  /// The path of a file of a result.
  std::string file_of(const std::string& key, const std::string& name) const;
  /// Its SHA-256; empty if there is no such file.
  std::string hash_of(const std::string& key, const std::string& name) const;
  std::string golden_picture(const std::string& sha256) const;

  Result<void> write_manifest(const std::vector<BatchJob>& jobs) const;
  Result<std::vector<BatchJob>> manifest() const;
  Result<void> write_row(const BatchRow& row) const;
  std::optional<BatchRow> row(const std::string& id) const;
  const std::string& path() const { return path_; }

 private:
  explicit RunFolder(std::string path) : path_(std::move(path)) {}
  std::string row_file(const std::string& id) const;

  std::string path_;
};

}  // namespace pentimento
