#pragma once
// The golden results of a batch: what each id gave when somebody looked at it and found it right.
//
//     index.jsonl           a line for each id, sorted: id, exit code, hashes of state and picture
//     pictures/SHA256.png   the pictures, each named by its own hash
//     states/SHA256.h5      the dumps, if the batch keeps them
//     changes.jsonl         a line for each change: when, why, which ids
//
// The index is small and is read whole. A picture is read only if its hash is not that of the
// result's.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/row.h"
#include "replay/batch/run_folder.h"

namespace pentimento {

struct GoldenEntry {
  std::string id;
  int exit_code = 0;
  std::string state_sha256;    // of the state, as the report has it
  std::string picture_sha256;  // of the file; empty without one
  std::string dump_sha256;     // of the file; empty without one
};

class GoldenStore {
 public:
  /// Reads the index of the folder; a folder without one has no entries. Errors: kBadInput with
  /// file and line, also for an id that it has twice.
  static Result<GoldenStore> open(const std::string& path);

  /// nullptr if there is none.
  const GoldenEntry* find(const std::string& id) const;
  /// The path of the entry's picture. Errors: kIo if it is missing, kBadInput if it is no longer
  /// the one that was taken.
  Result<std::string> picture(const GoldenEntry& entry) const;
  std::string dump(const GoldenEntry& entry) const;

  /// Takes the results of `rows` as golden where they are not yet: a state or a picture that
  /// differs at all, or a new id. `reason` says why, for whoever reads changes.jsonl. Files that no
  /// entry names any more are removed. Nothing is written if nothing changed. Returns the ids
  /// taken. Errors: kIo.
  Result<std::vector<std::string>> update(const std::vector<BatchRow>& rows, const RunFolder& run,
                                          const std::string& reason);

 private:
  explicit GoldenStore(std::string path) : path_(std::move(path)) {}
  Result<GoldenEntry> take(const BatchRow& row, const RunFolder& run) const;
  bool is_taken(const BatchRow& row, const RunFolder& run) const;
  Result<void> write_index() const;
  void remove_unnamed() const;

  std::string path_;
  std::map<std::string, GoldenEntry> entries_;
};

}  // namespace pentimento
