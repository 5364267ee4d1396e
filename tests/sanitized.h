#pragma once
// What a test leaves out in a build with sanitizers, which takes ten times as long.

namespace pentimento::test {

/// Of many cases that differ in little a sanitized build takes every `kStride`th.
#if defined(PENTIMENTO_SANITIZED)
inline constexpr int kStride = 5;
#else
inline constexpr int kStride = 1;
#endif

}  // namespace pentimento::test
