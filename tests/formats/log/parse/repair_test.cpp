#include "formats/log/parse/repair.h"

#include <gtest/gtest.h>

#include <fstream>

#include "formats/log/reader.h"
#include "tests/formats/log/edit/edited.h"
#include "tests/formats/scratch.h"

namespace pentimento::log {
namespace {

using enum TouchPhase;
using Lines = std::vector<std::string>;

Lines mended(const std::vector<Event>& events, Lines* notes = nullptr) {
  Repair repair;
  std::vector<Event> out;
  const auto append = [&](const std::vector<Event>& more) {
    out.insert(out.end(), more.begin(), more.end());
  };
  for (const Event& event : events) append(repair.mend(event));
  append(repair.finish());
  if (notes != nullptr) *notes = repair.notes();
  return lines_of(out);
}

TEST(Repair, LeavesWhatIsRight) {
  const std::vector<Event> events = {touch(1, kDown),       touch(2, kMove),
                                     at(2, Undo{}),         touch(3, kUp),
                                     touch(4, kDown, 0, 7), touch(5, kCancel, 0, 7)};
  Lines notes;
  EXPECT_EQ(mended(events, &notes), lines_of(events));
  EXPECT_TRUE(notes.empty());
}

TEST(Repair, ATimeThatRunsBackIsThatOfTheEventBefore) {
  EXPECT_EQ(mended({at(2, Undo{}), at(1, Redo{}), at(3, Undo{})}),
            lines_of({at(2, Undo{}), at(2, Redo{}), at(3, Undo{})}));
}

TEST(Repair, StrokesHaveABeginningAndAnEnd) {
  Lines notes;
  EXPECT_EQ(mended({touch(1, kMove, 0.1), touch(2, kMove, 0.2), touch(3, kDown, 0.3),
                    touch(4, kUp, 0.4), touch(5, kUp, 0.5), touch(6, kDown, 0.6)},
                   &notes),
            lines_of({touch(1, kDown, 0.1), touch(2, kMove, 0.2), touch(3, kUp, 0.2),
                      touch(3, kDown, 0.3), touch(4, kUp, 0.4), touch(6, kDown, 0.6),
                      touch(6, kUp, 0.6)}));
  EXPECT_EQ(notes, (Lines{"1 strokes without a beginning", "2 strokes without an end",
                          "1 ends without a stroke"}));
}

TEST(Repair, AReaderDropsTheLinesThatNoLogMayHaveAndSaysWhich) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.jsonl");
  std::ofstream(path) << R"({"type":"header","format":"pentimento-log","version":1,)"
                         R"("canvas":{"width":1,"height":1}})"
                         "\n"
                         R"({"t":1,"type":"brush","name":"nonsense"})"
                         "\n"
                         R"({"t":1,"type":"slider","name":"gamma","value":0.9})"
                         "\n"
                         R"({"t":1,"type":"slider","name":"gamma","value":0.3})"
                         "\n"
                         R"({"t":2,"type":"touch","phase":"down","x":0.5,"y":0.5})"
                         "\n"
                         R"({"t":3,"type":"touch","pha)";
  EXPECT_FALSE((*Reader::open(path, {}))->next());
  ReaderOptions options;
  options.repair = true;
  auto reader = Reader::open(path, options);
  ASSERT_TRUE(reader);
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<Event> events;
    while (true) {
      const auto event = (*reader)->next();
      ASSERT_TRUE(event) << event.error().message;
      if (!*event) break;
      events.push_back(**event);
    }
    EXPECT_EQ(lines_of(events), (Lines{R"({"t":1,"type":"slider","name":"gamma","value":0.3})",
                                       R"({"t":2,"type":"touch","phase":"down","x":0.5,"y":0.5})",
                                       R"({"t":2,"type":"touch","phase":"up","x":0.5,"y":0.5})"}));
    EXPECT_EQ((*reader)->repaired(), (Lines{"1 strokes without an end", "3 lines dropped",
                                            "line 2: brush \"nonsense\" is unknown",
                                            "line 3: gamma 0.9 is not below zeta 0.8",
                                            "line 6: not valid JSON: it does not end"}));
    ASSERT_TRUE((*reader)->rewind());
  }
}

}  // namespace
}  // namespace pentimento::log
