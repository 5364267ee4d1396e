#include <gtest/gtest.h>

#include "tests/core/fluid/conservative/painting_session.h"

namespace pentimento::conservative {
namespace {

TEST(ConservativeScheme, BalancesTheBooksOfASession) {
  // The promise for a 20-minute session is 1e-6 (tests/bench/drift_bench.cpp runs one); transport
  // adds nothing, so what drifts is the brush's own rounding, which this bounds.
  const Threads threads;
  PaintingSession session(128, threads);
  for (int k = 0; k < 12; ++k) session.stroke();
  for (const double drift : session.drifts()) EXPECT_LT(drift, 1e-6);
  EXPECT_EQ(session.simulation().first_non_finite(), "");
}

}  // namespace
}  // namespace pentimento::conservative
