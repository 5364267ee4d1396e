#include "core/base/any_not_zero.h"

#include "core/base/kernel.h"

namespace pentimento {

namespace {
PENTIMENTO_KERNEL
bool find(const float* values, int n) {
  int any = 0;  // not a bool, which keeps the loop from being a vector's
  for (int i = 0; i < n; ++i) any |= values[i] != 0 ? 1 : 0;
  return any != 0;
}
}  // namespace

bool search_not_zero(const float* values, int n) {
  return find(values, n);
}

}  // namespace pentimento
