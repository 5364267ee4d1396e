#pragma once
// Replays of valid logs.

#include <string_view>

namespace pentimento::test {

/// The bytes choose a log and a step. The log is replayed by one thread, by others, and by one that
/// is saved at the step and goes on from what was saved: each gives the same state, which is
/// finite, and the account of the paint balances.
void fuzz_replay(std::string_view bytes);

}  // namespace pentimento::test
