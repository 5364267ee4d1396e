#include "core/simulation/make_scheme.h"

#include "core/base/check.h"
#include "core/fluid/conservative/conservative_scheme.h"
#include "core/fluid/paper/paper_scheme.h"

namespace pentimento {

std::unique_ptr<FluidScheme> make_scheme(SchemeKind kind, const CanvasGeometry& geometry,
                                         int layers, int channels) {
  switch (kind) {
    case SchemeKind::kPaper:
      return std::make_unique<paper::PaperScheme>(geometry, layers, channels);
    case SchemeKind::kConservative:
      return std::make_unique<conservative::ConservativeScheme>(geometry);
  }
  check_failed("the scheme exists", __FILE__, __LINE__);
}

}  // namespace pentimento
