#pragma once
// libhdf5 loses a few bytes when it gives up on a broken file. While this lives, the leak checker
// does not look at what is allocated.

#if defined(__SANITIZE_ADDRESS__)
#define PENTIMENTO_LEAK_CHECK 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PENTIMENTO_LEAK_CHECK 1
#endif
#endif
#ifdef PENTIMENTO_LEAK_CHECK
#include <sanitizer/lsan_interface.h>
#endif

namespace pentimento::test {

class IgnoreLibraryLeaks {
 public:
#ifdef PENTIMENTO_LEAK_CHECK
  IgnoreLibraryLeaks() {
    __lsan_disable();
  }
  ~IgnoreLibraryLeaks() {
    __lsan_enable();
  }
#else
  IgnoreLibraryLeaks() {}
  ~IgnoreLibraryLeaks() {}
#endif
  IgnoreLibraryLeaks(const IgnoreLibraryLeaks&) = delete;
  IgnoreLibraryLeaks& operator=(const IgnoreLibraryLeaks&) = delete;
};

}  // namespace pentimento::test
