#pragma once
// What a checkpoint is bound to: all that the result of a job depends on, as names and values. A
// slot serves only a job for which all of them are the same.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formats/checkpoint/archive.h"
#include "replay/job/render_job.h"
#include "replay/session/log_session.h"

namespace pentimento {

using Binding = std::vector<std::pair<std::string, std::string>>;

/// Call it when everything that the log names has been read once. `files_of_options`: option, as
/// "--from", and the SHA-256 of its file.
Binding binding_of(const RenderJob& job, const LogSession& session,
                   const std::map<std::string, std::string>& files_of_options);

void put_binding(const Binding& binding, checkpoint::ArchiveWriter& to);
Binding take_binding(checkpoint::ArchiveReader& from);

/// What a slot with the binding `kept` was made for that `now` is not: "detail 2, not 3". Empty if
/// there is no difference.
std::string difference(const Binding& kept, const Binding& now);

}  // namespace pentimento
