#pragma once
// Reads a dump once in a child process first. libhdf5 does not withstand every damaged file: a
// flipped byte in its tables can make it read outside its memory or loop. What happens to the child
// then becomes an error here, not the end of the programme.

#include <functional>
#include <string>

#include "core/base/result.h"

namespace pentimento::hdf5 {

/// Runs `read` in a child of this process and returns what it returned. Errors: kBadInput with
/// `path` if the child dies or takes longer than any dump can take; kIo if no child can be started.
Result<bool> rehearse(const std::string& path, const std::function<bool()>& read);

}  // namespace pentimento::hdf5
