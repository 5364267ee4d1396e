#pragma once
// What planes take of the machine's memory.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>

namespace pentimento {

/// Memory of this process that is in use, MiB.
inline long resident_mib() {
  std::ifstream file("/proc/self/statm");
  long program_pages = 0;
  long resident_pages = 0;
  file >> program_pages >> resident_pages;
  return resident_pages * 4 / 1024;  // Pages of 4 KiB.
}

/// What reading a plane of so many MiB takes of a system that has no common page of zeros for it.
inline long taken_by_reading_mib(long plane_mib) {
  constexpr std::size_t kBytes = std::size_t{16} << 20;
  constexpr std::size_t kPage_bytes = 4096;
  const long before_mib = resident_mib();
  const std::unique_ptr<unsigned char, decltype(&std::free)> block(
      static_cast<unsigned char*>(std::calloc(kBytes, 1)), &std::free);
  unsigned sum = 0;
  for (std::size_t at = 0; at < kBytes; at += kPage_bytes)
    sum += *static_cast<volatile const unsigned char*>(block.get() + at);
  EXPECT_EQ(sum, 0u);
  return resident_mib() - before_mib > 8 ? plane_mib : 0;  // 16 or none
}

/// The thread sanitizer marks all values of a block as written when it is given.
inline bool is_marked_when_given() {
#if defined(__has_feature)
  return __has_feature(thread_sanitizer);
#else
  return false;
#endif
}

}  // namespace pentimento
