#pragma once
// The outputs of the stops that a replay has passed, as a checkpoint keeps them.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/checkpoint/archive.h"
#include "formats/io/output_file.h"
#include "replay/job/report.h"
#include "replay/output/output_plan.h"

namespace pentimento {

struct KeptOutput {
  WrittenFile file;
  // Of a film, the checksums of its frames up to now. Another file is whole.
  std::optional<std::vector<std::uint64_t>> frames;
};

void put_outputs(const std::vector<KeptOutput>& outputs, checkpoint::ArchiveWriter& to);
std::vector<KeptOutput> take_outputs(checkpoint::ArchiveReader& from);

/// Whether `file` is the name of one of the planned files or of an AOV beside one of them: a
/// checkpoint that somebody forged must not have a job write elsewhere.
bool is_planned(const std::string& file, const std::vector<std::vector<PlannedOutput>>& planned);

/// Where a checkpoint in `folder` keeps the bytes of output `index`.
std::string kept_file(const std::string& folder, std::size_t index);
/// Where it keeps the frames of output `index`, a film.
std::string kept_frames(const std::string& folder, std::size_t index);

/// Copies the kept bytes into a new file beside `file`'s target, complete but without its name.
/// Errors: kIo, kBadInput for bytes that do not have the hash of `file`.
Result<std::unique_ptr<OutputFile>> adopt_kept(const std::string& kept, const WrittenFile& file,
                                               bool no_clobber);

}  // namespace pentimento
