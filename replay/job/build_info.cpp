#include "replay/job/build_info.h"

namespace pentimento {

std::string version() {
  return PENTIMENTO_VERSION;
}

std::string software() {
  return "pentimento " PENTIMENTO_VERSION " (" PENTIMENTO_BUILD ")";
}

}  // namespace pentimento
