#include "core/base/require_memory.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(RequireMemory, ARefusalIsThatOfTheMachine) {
  EXPECT_NO_THROW(require_memory(true));
  EXPECT_THROW(require_memory(false), std::bad_alloc);
}

}  // namespace
}  // namespace pentimento
