#pragma once
// A valid log that a fuzzer's bytes choose: short sessions on 32 x 24 cells with brushes, sliders,
// colours, two touches, gravity, undo and redo, drying and clearing. All but one in 256 have the
// same palette and pick no other colours, so that what is made for a palette can be made once.

#include "tests/fuzz/choices.h"
#include "tests/replay/list_reader.h"

namespace pentimento::test {

struct GrammarLog {
  ListReader log;
  bool usual = true;  // of the palette that nearly all have
};
GrammarLog grammar_log(Choices& choices);

}  // namespace pentimento::test
