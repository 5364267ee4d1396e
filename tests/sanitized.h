#pragma once
// What a test leaves out in a build with sanitizers, which takes ten times as long, has more memory
// mapped, and listens to signals of its own.

namespace pentimento::test {

#if defined(PENTIMENTO_SANITIZED)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Of many cases that differ in little a sanitized build takes every `kStride`th.
inline constexpr int kStride = kSanitized ? 5 : 1;

}  // namespace pentimento::test
