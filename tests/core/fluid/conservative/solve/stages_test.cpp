#include "core/fluid/conservative/solve/stages.h"

#include <gtest/gtest.h>

namespace pentimento::conservative {
namespace {

// Runs `stages` stages over the rows that `has_run` names, in bands of `cells` cells, and checks
// them against the definition: a stage sees the stage before of three rows, if there is one, and
// none of the stage after it.
void check_stages(int height, int stages, std::int64_t cells, const Threads& threads,
                  const std::function<bool(int y)>& has_run) {
  std::vector<Run> runs;
  for (int y = 0; y < height; ++y)
    if (has_run(y)) runs.push_back({y, 0, 30});
  const RunIndex index(runs, height);
  std::vector<int> done(static_cast<std::size_t>(height), 0);
  for_stages_in(cells, threads, index, stages, [&](int stage, const Run& r) {
    const auto state = [&](int y) { return done[static_cast<std::size_t>(y)]; };
    EXPECT_EQ(state(r.y), stage);
    for (const int y : {r.y - 1, r.y + 1}) {
      if (y < 0 || y >= height || !has_run(y)) continue;
      EXPECT_GE(state(y), stage);
      EXPECT_LE(state(y), stage + 1);
    }
    ++done[static_cast<std::size_t>(r.y)];
  });
  for (int y = 0; y < height; ++y)
    EXPECT_EQ(done[static_cast<std::size_t>(y)], has_run(y) ? stages : 0) << y;
}

TEST(Stages, BandsGiveWhatPlainPassesGive) {
  // One band, and bands as low as they get; from either end.
  for (const int height : {1, 7, 20, 63, 1063})
    for (const std::int64_t cells : {1, 1000, 1000000})
      for (const bool backwards : {false, true})
        check_stages(height, 6, cells, backwards ? Threads::backwards() : Threads(),
                     [](int) { return true; });
}

TEST(Stages, RowsWithoutRunsPartTheGrid) {
  // Islands of all heights, each with one empty row below it, and empty rows at both ends.
  const auto islands = [](int y) {
    int first = 3;
    for (int rows = 1; first <= y; first += rows + 1, ++rows)
      if (y < first + rows) return true;
    return false;
  };
  for (const int height : {2, 4, 300})
    for (const int stages : {1, 2, 8})
      for (const bool backwards : {false, true})
        check_stages(height, stages, 1, backwards ? Threads::backwards() : Threads(), islands);
}

TEST(Stages, AnEmptyGridHasNoStages) {
  check_stages(40, 3, 1, Threads(), [](int) { return false; });
  for_stages(Threads(), RunIndex(), 3, [](int, const conservative::Run&) { FAIL(); });
}

TEST(Stages, BandsAreCutByTheirCellsNotTheirRows) {
  // 20 wide rows over 200 narrow ones: each half of the cells has a band of its own.
  std::vector<conservative::Run> runs;
  for (int y = 0; y < 220; ++y) runs.push_back({y, 0, y < 20 ? 1000 : 100});
  const RunIndex index(runs, 220);
  EXPECT_EQ(index.cells(), 40000);
  EXPECT_EQ(index.cells({10, 30}), 11000);
  std::vector<int> first_rows;  // stage 0 of a band follows no other row's stage 0 directly
  int last = -2;
  for_stages_in(20000, Threads::backwards(), index, 1, [&](int, const conservative::Run& r) {
    if (r.y != last + 1) first_rows.push_back(r.y);
    last = r.y;
  });
  EXPECT_EQ(first_rows, (std::vector<int>{20, 0}));
}

}  // namespace
}  // namespace pentimento::conservative
