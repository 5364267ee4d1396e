#pragma once
// What fuzzing calls: each reader of files that others made, and what its result goes through next;
// and replays of valid logs.
// The fuzzer (fuzz_main.cpp) and the test of the kept inputs (fuzz_corpus_test.cpp) share it.

#include <string>
#include <string_view>
#include <vector>

namespace pentimento::test {

/// The names of all targets, those of the formats of recordings last.
std::vector<std::string> fuzz_targets();

/// Reads the bytes as the target does; `dump-child` and `dump-edits-child` read them as a user's
/// dump is read, which takes a process for each. Whatever they are, it may say what is wrong, in
/// one line that names the file; anything else ends the process.
void fuzz(const std::string& target, std::string_view bytes);

}  // namespace pentimento::test
