#pragma once
// A valid log that a fuzzer's bytes choose: short sessions on 32 x 24 cells with brushes, sliders,
// colours, two touches, gravity, undo and redo, drying and clearing. Strokes are of a few stamps,
// so that a replay takes a millisecond.

#include "tests/fuzz/choices.h"
#include "tests/replay/list_reader.h"

namespace pentimento::test {

ListReader grammar_log(Choices& choices);

}  // namespace pentimento::test
