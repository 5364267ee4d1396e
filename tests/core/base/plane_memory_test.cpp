#include "core/base/plane_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/field.h"

namespace pentimento {
namespace {

constexpr int kSide = 1024;  // planes of 4 MiB

bool gives_large_pages() {
#if defined(__SANITIZE_ADDRESS__)
  return false;  // each plane has memory of its own, so that overflows are found
#elif defined(__has_feature)
  return !__has_feature(address_sanitizer);
#else
  return true;
#endif
}

TEST(PlaneMemory, PlanesAreZeroApartAndAtCacheLines) {
  PlaneMemory memory(3, kSide, kSide);
  std::vector<Field<float>> planes;
  for (int i = 0; i < 5; ++i) planes.emplace_back(kSide, kSide, memory);  // two more than asked for
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(planes[i].row(0)) % 64, 0u);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) ASSERT_EQ(planes[i](x, y), 0.0f);
    planes[i].fill(static_cast<float>(i + 1));
  }
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) ASSERT_EQ(planes[i](x, y), static_cast<float>(i + 1));
}

TEST(PlaneMemory, PlanesOutliveWhatGaveThemAndEachOther) {
  std::optional<Field<float>> kept;
  {
    PlaneMemory memory(4, kSide, kSide);
    Field<float> gone(kSide, kSide, memory);
    kept.emplace(kSide, kSide, memory);
    gone.fill(1);
    kept->fill(2);
  }
  Field<float> moved = std::move(*kept);
  kept.reset();
  EXPECT_EQ(moved(kSide - 1, kSide - 1), 2);
}

TEST(PlaneMemory, NothingForSmallAndForHugePlanes) {
  EXPECT_EQ(PlaneMemory().take(64), nullptr);
  EXPECT_EQ(PlaneMemory(10, 64, 48).take(64), nullptr);
  EXPECT_EQ(PlaneMemory(10, 4096, 1025).take(64), nullptr);  // a row over 16 MiB
  EXPECT_EQ(PlaneMemory(10, 4096, 1024).take(64) != nullptr, gives_large_pages());
}

/// Whether the mapping of `address` may have large pages, by what the system says of it; none where
/// the system does not say.
std::optional<bool> may_be_large(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    const std::size_t dash = line.find('-');
    const bool is_range = dash != std::string::npos && line.find(' ') > dash && line[0] != 'V';
    if (is_range && line.find(':') > dash + 1) {
      const auto at = reinterpret_cast<std::uintptr_t>(address);
      const std::uintptr_t begin = std::stoull(line.substr(0, dash), nullptr, 16);
      const std::uintptr_t end = std::stoull(line.substr(dash + 1), nullptr, 16);
      here = at >= begin && at < end;
    } else if (here && line.rfind("VmFlags:", 0) == 0) {
      return line.find(" hg") != std::string::npos;
    }
  }
  return std::nullopt;
}

TEST(PlaneMemory, AsksForLargePages) {
  if (!gives_large_pages()) GTEST_SKIP() << "planes have memory of their own here";
  PlaneMemory memory(4, kSide, kSide);
  void* const plane = memory.take(sizeof(float) * kSide * kSide);
  ASSERT_NE(plane, nullptr);
  EXPECT_EQ(may_be_large(plane).value_or(true), true);
}

}  // namespace
}  // namespace pentimento
