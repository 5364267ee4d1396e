#pragma once
// The temporary files and the locks that this process has open, for the moment in which it must end
// at once: a signal handler may remove files, but it can ask no object which. So this is a table of
// the process, of a fixed size; what finds no place in it is left to the next run.

#include <string>

namespace pentimento {

/// Keeps the name until forget_temporary(). Any thread may call both.
void note_temporary(const std::string& path);
void forget_temporary(const std::string& path);

/// Removes the files that are noted. Calls nothing that a signal handler may not.
void remove_temporaries();

}  // namespace pentimento
