#include "formats/checkpoint/detail_part.h"

#include <gtest/gtest.h>

namespace pentimento::checkpoint {
namespace {

const DetailLayout kLayout({6, 4, 0.6, 0.4}, 2);
constexpr int kLayers = 2, kChannels = 2;

DetailNotes some_notes() {
  DetailNotes notes;
  notes.checkpoint = make_checkpoint(kLayout, kLayers * kChannels);
  notes.checkpoint.tile[kCheckpointMade] = 1;
  notes.checkpoint.block[3] = kCheckpointMerges | 1u;
  notes.checkpoint.waiting[5] = 9;
  notes.checkpoint.stamped = {{5, 3, {0.6f, -0.8f}, true}};
  notes.lock.blocks[2] = 17;
  notes.lock.owed = 4;
  return notes;
}

DetailNotes taken(const std::string& bytes, std::string& problem) {
  ArchiveReader from(bytes);
  DetailNotes notes = take_detail(kLayout, kLayers, kChannels, from);
  from.complete();
  problem = from.problem();
  return notes;
}

std::string bytes_of(const DetailNotes& notes) {
  ArchiveWriter to;
  put_detail(notes, to);
  return to.take();
}

TEST(DetailPart, BringsBackEveryNote) {
  std::string problem;
  const DetailNotes back = taken(bytes_of(some_notes()), problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(back.checkpoint, some_notes().checkpoint);
  EXPECT_EQ(back.lock.blocks, some_notes().lock.blocks);
  EXPECT_EQ(back.lock.owed, 4);
}

TEST(DetailPart, RefusesWhatNoCanvasOfThatLayoutHas) {
  const auto problem_with = [](const auto& change) {
    DetailNotes notes = some_notes();
    change(notes.checkpoint);
    std::string problem;
    taken(bytes_of(notes), problem);
    return problem;
  };
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.tile.pop_back(); }), "");
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.block.push_back(0); }), "");
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.block[0] = 2; }), "") << "of two layers";
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.stamped[0].x = 6; }), "");
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.stamped[0].y = -1; }), "");
  EXPECT_NE(problem_with([](DetailCheckpoint& c) { c.stamped[0].way.x = 5; }), "");
}

TEST(DetailPart, CutAnywhereIsRefused) {
  const std::string bytes = bytes_of(some_notes());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::string problem;
    taken(bytes.substr(0, size), problem);
    EXPECT_NE(problem, "") << size;
  }
}

}  // namespace
}  // namespace pentimento::checkpoint
