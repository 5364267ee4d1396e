#include "replay/paper/paper_relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/base/resident_memory.h"

namespace pentimento {
namespace {

struct Facts {
  double mean = 0, rms = 0, min = 1, max = 0;
};

Facts facts_of(const std::string& texture, int width, int height) {
  log::PaperSpec paper;
  paper.texture = texture;
  paper.relief_m = 1;
  paper.scale_m = 0.05;
  LogFiles files("-", false);
  const Result<Field<float>> made = paper_relief(paper, {width, height, 0.2, 0.15}, files);
  const Field<float>& relief = *made;
  Facts facts;
  double squares = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double h = static_cast<double>(relief(x, y));
      facts.mean += h / width / height;
      squares += h * h / width / height;
      facts.min = std::min(facts.min, h);
      facts.max = std::max(facts.max, h);
    }
  }
  facts.rms = std::sqrt(std::max(0.0, squares - facts.mean * facts.mean));
  return facts;
}

TEST(PaperRelief, ASmoothOneTakesNoMemory) {
  if (is_marked_when_given()) GTEST_SKIP();
  log::PaperSpec paper;
  LogFiles files("-", false);
  for (const bool flat : {false, true}) {
    paper.texture = flat ? "linen" : "smooth";
    paper.relief_m = flat ? 0 : 1;
    const long before_mib = resident_mib();
    // A plane of 256 MiB, and a sanitizer's shadow of it.
    const Result<Field<float>> made = paper_relief(paper, {8192, 8192, 0.2, 0.2}, files);
    ASSERT_TRUE(made);
    EXPECT_LT(resident_mib() - before_mib, 80);
  }
}

TEST(PaperRelief, StaysWithinTheRelief) {
  for (const std::string& texture : builtin_papers()) {
    const Facts facts = facts_of(texture, 400, 300);
    EXPECT_GE(facts.min, 0.0) << texture;
    EXPECT_LE(facts.max, 1.0) << texture;
  }
  EXPECT_EQ(facts_of("smooth", 40, 30).max, 0.0);
}

TEST(PaperRelief, IsTheSamePaperAtEveryResolution) {
  // 8 and 16 cells a thread: the mean is kept to the rounding of means, the relief to what a cell
  // of an eighth of a thread smooths away.
  for (const char* texture : {"linen", "canvas"}) {
    const Facts coarse = facts_of(texture, 1024, 768);
    const Facts fine = facts_of(texture, 2048, 1536);
    EXPECT_NEAR(coarse.mean, fine.mean, 1e-3) << texture;
    EXPECT_NEAR(coarse.rms, fine.rms, 0.03 * fine.rms) << texture;
    EXPECT_GT(fine.rms, 0.1) << texture;
  }
}

TEST(PaperRelief, ThreadsFinerThanACellVanish) {
  // 24 cells over 4 repeats of 32 threads: 5 threads a cell leave a tenth of the relief at most.
  EXPECT_LT(facts_of("linen", 24, 18).rms, 0.1 * facts_of("linen", 2048, 1536).rms);
}

/// Expects papers that repeat after 10 cm to repeat after so many cells, on two repeats each way.
void expect_repeat(int across, int down) {
  log::PaperSpec paper;
  paper.relief_m = 1;
  paper.scale_m = 0.1;
  LogFiles files("-", false);
  for (const char* texture : {"linen", "canvas", "paper"}) {
    paper.texture = texture;
    const Result<Field<float>> relief =
        paper_relief(paper, {2 * across, 2 * down, 0.2, 0.2}, files);
    for (int x = 0; x < across; ++x) {
      EXPECT_NEAR((*relief)(x, 5), (*relief)(x + across, 5), 1e-5) << texture;
      EXPECT_NEAR((*relief)(x, 5), (*relief)(x, 5 + down), 1e-5) << texture;
    }
  }
}

TEST(PaperRelief, TheRepeatCloses) {
  expect_repeat(128, 128);
}

TEST(PaperRelief, TheRepeatIsSquareOnLongCellsToo) {
  expect_repeat(128, 64);  // cells of 1 by 2
}

}  // namespace
}  // namespace pentimento
