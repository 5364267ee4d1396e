#pragma once
// The file of hashes that `render --hashes` writes and `verify` reads: what a replay's state was
// after each of its steps (docs/verify.md). JSON Lines; `.gz` and `.zst` are compressed.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/io/output_file.h"
#include "replay/hashes/field_hashes.h"

namespace pentimento {

struct HashHeader {
  std::string log_sha256;
  std::string software;
  std::string command;                  // that wrote it, without its outputs
  int width = 0, height = 0;            // cells
  int tile_width = 0, tile_height = 0;  // cells
};

/// After a step that was computed. Idle steps, which change nothing, are left out.
struct StepHashes {
  std::int64_t step = 0;  // steps done
  std::int64_t line = 0;  // of the log, of the last event before it; 0: none yet
  FieldHashArray fields{};
  std::vector<TileHash> tiles;  // that changed in this step
};

class HashWriter {
 public:
  /// Errors: kIo.
  static Result<std::unique_ptr<HashWriter>> create(const std::string& path,
                                                    const HashHeader& header, bool no_clobber);
  ~HashWriter();
  void write(const StepHashes& step);
  /// The file is whole under its temporary name; publish() gives it its own. Errors: kIo.
  Result<Published> complete();
  Result<Published> publish();

 private:
  struct Impl;
  explicit HashWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

class HashReader {
 public:
  /// Errors: kIo; kBadInput for what is no file of hashes.
  static Result<std::unique_ptr<HashReader>> open(const std::string& path);
  ~HashReader();
  const HashHeader& header() const;
  /// The next step, or nothing at the end. Errors: kBadInput with file and line.
  Result<std::optional<StepHashes>> next();

 private:
  struct Impl;
  explicit HashReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento
