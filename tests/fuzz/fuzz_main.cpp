// The fuzzer, on libFuzzer. PENTIMENTO_FUZZ names the target; `list` prints all names.

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz_target.h"

namespace {
std::string& target() {
  static std::string name;
  return name;
}
}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* name = std::getenv("PENTIMENTO_FUZZ");
  target() = name == nullptr ? "" : name;
  const std::vector<std::string> all = pentimento::test::fuzz_targets();
  const std::string_view known = std::string_view(target()).substr(0, target().rfind("-child"));
  if (std::find(all.begin(), all.end(), known) != all.end()) return 0;
  for (const std::string& one : all) std::puts(one.c_str());
  std::exit(target() == "list" ? 0 : 2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  pentimento::test::fuzz(target(), {reinterpret_cast<const char*>(bytes), size});
  return 0;
}
