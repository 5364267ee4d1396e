#include "core/simulation/make_scheme.h"

#include <gtest/gtest.h>

#include "core/fluid/conservative/conservative_scheme.h"
#include "core/fluid/paper/paper_scheme.h"

namespace pentimento {
namespace {

TEST(MakeScheme, MakesTheFluidThatTheModelNames) {
  const CanvasGeometry geometry{8, 6, 0.08, 0.06};
  const auto paper = make_scheme(SchemeKind::kPaper, geometry, 2, 1);
  const auto conservative = make_scheme(SchemeKind::kConservative, geometry, 2, 1);
  EXPECT_NE(dynamic_cast<paper::PaperScheme*>(paper.get()), nullptr);
  EXPECT_NE(dynamic_cast<conservative::ConservativeScheme*>(conservative.get()), nullptr);
}

}  // namespace
}  // namespace pentimento
